// Deletes, copies and pastes the selection.
#include <QApplication>
#include <QClipboard>
#include <QMimeData>
#include <algorithm>
#include <cmath>
#include <functional>

#include "authoring/authoring.h"
#include "authoring/pieces.h"
#include "engine/workbench.h"
#include "scene/stage.h"

namespace elsie::desktop {
namespace {

constexpr auto kMime = "application/x-elsie-element";
constexpr double kAside_m = 0.3;  // distance between the places that are tried for a copy
constexpr int kMostRings = 12;

QString clipboard_text() {
  const QMimeData* held = QApplication::clipboard()->mimeData();
  return held->hasFormat(kMime) ? QString::fromUtf8(held->data(kMime)) : held->text();
}

}  // namespace

// The selected paths in the order of the world, without those inside other selected elements.
QStringList Authoring::wholes() const {
  QStringList paths;
  visit(workbench_.tree(), [&](const ElementPlace& place) {
    const bool is_chosen =
        place.list.isEmpty() && !place.path.isEmpty() && selection_.contains(place.path);
    if (is_chosen) {
      paths << place.path;
    }
    return !is_chosen;
  });
  return paths;
}

void Authoring::remove_selected() {
  const QStringList paths = wholes();
  QStringList edits;
  // From the last to the first: an edit may change the paths of the elements after it.
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    edits << *path + "/@remove=true";
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits,
                    paths.size() == 1
                        ? tr("delete %1").arg(title(paths.front()))
                        : tr("delete %n things", nullptr, static_cast<int>(paths.size())),
                    {}, this, [this](const Problems& problems) {
                      if (problems.empty()) select({});  // the next one has this path now
                    });
  } else {
    Q_EMIT said(tr("Nothing is selected that can be deleted."));
  }
}

QString Authoring::markup_of_selected() const {
  QString text;
  for (const QString& path : wholes()) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    const QString holder = place.parent ? name_of(*place.parent) : QString();
    text += listed(markup_of(*place.element), member_word(holder).isEmpty() ? QString() : holder) +
            '\n';
  }
  return text;
}

void Authoring::copy_selected() {
  const QString text = markup_of_selected();
  if (text.isEmpty()) {
    return;
  }
  auto* held = new QMimeData;
  held->setText(text);
  held->setData(kMime, text.toUtf8());
  copied_ = selection_;
  QApplication::clipboard()->setMimeData(held);
}

void Authoring::cut_selected() {
  copy_selected();
  remove_selected();
}

void Authoring::paste() { insert(clipboard_text(), tr("paste")); }

bool Authoring::may_paste_into(const QString& list) const {
  const std::vector<Piece> pieces = pieces_of(clipboard_text());
  return !pieces.empty() && std::all_of(pieces.begin(), pieces.end(), [&](const Piece& each) {
    return (each.list.isEmpty() ? list_for(each.name) : each.list) == list;
  });
}

bool Authoring::may_duplicate() const {
  const std::vector<Piece> pieces = pieces_of(markup_of_selected());
  QStringList taken;
  return !pieces.empty() && std::all_of(pieces.begin(), pieces.end(), [&](const Piece& each) {
    QString why;  // an element that would replace the present one has no [+]
    return insertion_of(each, {}, taken, why).section('=', 0, 0).endsWith(QLatin1String("[+]"));
  });
}

void Authoring::duplicate_selected() {
  copied_ = selection_;
  insert(markup_of_selected(), tr("duplicate"));
}

// The list for a piece that does not name its list.
QString Authoring::list_for(const QString& name) const {
  for (const char* list : {"robots", "obstacles", "resources", "chargers", "nests", "lamps",
                           "patches", "fields", "teams", "goals", "measures", "rules", "sensors",
                           "actuators", "behaviors", "coordinator"}) {
    for (const Kind& each : workbench_.catalog().members(list)) {
      if (each.name == name) {
        return list;
      }
    }
  }
  return {};
}

// The selected element, or one around it, that may hold this; none otherwise. What was copied where
// it is still selected goes beside it, also where it may hold its like.
std::optional<QString> Authoring::holder_of_part(const Piece& piece) const {
  QString path = selection_.value(0);
  const bool is_here = std::any_of(selection_.begin(), selection_.end(), [&](const QString& each) {
    const ElementPlace place = place_of(workbench_.tree(), each);
    return copied_.contains(each) && place.element && markup_of(*place.element) == piece.markup;
  });
  if (is_here) path = holder_of(path);
  for (; !path.isEmpty(); path = holder_of(path)) {
    const auto kind = workbench_.catalog().kind_of(place_of(workbench_.tree(), path));
    if (kind && kind->elements.contains(piece.name) && member_word(piece.name).isEmpty()) {
      return path;
    }
  }
  return std::nullopt;
}

QString Authoring::holder_for(const QString& list, const QString& path) const {
  const auto kind = workbench_.catalog().kind_of(place_of(workbench_.tree(), path));
  const bool holds = kind && kind->holds_behaviors && path.contains("/behavior[");
  return holds && (list == "behaviors" || list == "coordinator") ? path : robot_path(path);
}

void Authoring::insert(const QString& markup, const QString& name) {
  const std::vector<Piece> pieces = pieces_of(markup);
  if (pieces.empty()) {
    Q_EMIT said(tr("There is nothing to paste: copy elements of a world first."));
    return;
  }
  const QPointF aside = way_aside(pieces);
  QStringList edits, taken, places;
  for (const Piece& piece : pieces) {
    QString why;
    const QString edit = insertion_of(piece, aside, taken, why);
    if (edit.isEmpty()) {
      Q_EMIT said(why);
      return;
    }
    edits << edit;
    places << edit.section('=', 0, 0);
  }
  workbench_.edit(edits, name, {}, this, [this, places](const Problems& problems) {
    const bool is_carried = std::any_of(places.begin(), places.end(),
                                        [](const QString& each) { return each.contains('/'); });
    const QStringList made =
        is_carried ? QStringList() : last_of(places);  // the robot stays selected
    if (problems.empty() && !made.isEmpty()) {
      select(made);
    }
  });
}

QStringList Authoring::last_of(const QStringList& places) const {
  QHash<QString, QStringList> members;
  visit(workbench_.tree(), [&](const ElementPlace& place) {
    if (place.list.isEmpty() && place.parent) {
      const QString word = member_word(name_of(*place.parent));
      const QString holder = holder_of(place.path);
      members[(holder.isEmpty() ? QString() : holder + '/') +
              (word.isEmpty() ? name_of(*place.element) : word)]
          << place.path;
    }
    return true;
  });
  QStringList last;
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    QStringList& all = members[QString(*place).remove("[+]")];
    if (!all.isEmpty()) last.prepend(all.takeLast());
  }
  return last;
}

QPointF Authoring::way_aside(const std::vector<Piece>& pieces) const {
  const auto is_free = [&](const Piece& piece, const QPointF& by) {
    const QPointF at(attribute_of(piece, "x").toDouble() + by.x(),
                     attribute_of(piece, "y").toDouble() + by.y());
    const double room = room_of([&](const char* name) { return attribute_of(piece, name); });
    return std::abs(at.x()) + room < 0.5 * stage_.length() &&
           std::abs(at.y()) + room < 0.5 * stage_.width() && stage_.is_free(at, room) &&
           is_free_at_start(workbench_.tree(), at, room);
  };
  // A waypoint has no body, but another waypoint is at its place.
  const bool is_way = std::any_of(pieces.begin(), pieces.end(),
                                  [](const Piece& each) { return each.name == "waypoint"; });
  for (int ring = is_way ? 1 : 0; ring <= kMostRings; ++ring) {
    for (int i = 0; i < (ring == 0 ? 1 : 8); ++i) {
      const double angle = 2.0 * M_PI * i / 8;
      const QPointF by(std::round(1e3 * ring * kAside_m * std::cos(angle)) / 1e3,
                       std::round(1e3 * ring * kAside_m * std::sin(angle)) / 1e3);
      if (std::all_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
            return attribute_of(piece, "x").isEmpty() || is_free(piece, by);
          })) {
        return by;
      }
    }
  }
  return {kAside_m, 0.0};
}

QString Authoring::insertion_of(Piece piece, const QPointF& aside, QStringList& taken,
                                QString& why) const {
  const auto stand_aside = [&] {
    piece.markup =
        with_attribute(piece, "x", number(attribute_of(piece, "x").toDouble() + aside.x()));
    if (aside.y() != 0.0) {
      piece.markup =
          with_attribute(piece, "y", number(attribute_of(piece, "y").toDouble() + aside.y()));
    }
  };
  if (const auto holder = piece.list.isEmpty() ? holder_of_part(piece) : std::nullopt) {
    if (piece.name == "waypoint") stand_aside();
    return *holder + '/' + piece.name + "[+]=" + piece.markup;
  }
  const QString list = piece.list.isEmpty() ? list_for(piece.name) : piece.list;
  if (list.isEmpty()) {
    why = tr("'%1' is not an element that can be pasted into a world.").arg(piece.name);
    return {};
  }
  const bool is_carried = list == "sensors" || list == "actuators" || list == "behaviors" ||
                          list == "coordinator" || list == "drive";
  const QString holder = is_carried ? holder_for(list, selection_.value(0)) : QString();
  if (is_carried && holder.isEmpty()) {
    why = tr("Select the robot that '%1' is for.").arg(piece.name);
    return {};
  }
  const QString place = (is_carried ? holder + '/' : QString()) + member_word(list);
  if (list == "coordinator" || list == "drive") {  // it replaces the present one
    const bool is_there = place_of(workbench_.tree(), place).element != nullptr;
    return place + (is_there ? "=" : "[+]=") + piece.markup;
  }
  // Its id and its place are in use: it gets a new id and stands aside.
  const QString id = piece.name == "robot" ? free_id(workbench_.tree(), "r", taken) : QString();
  taken << id;
  piece.markup = with_attribute(piece, "id", id);
  if (kPlaced.contains(list)) stand_aside();
  return place + "[+]=" + piece.markup;
}

}  // namespace elsie::desktop
