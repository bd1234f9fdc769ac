// Deleting, copying and pasting of what is chosen.
#include <QApplication>
#include <QClipboard>
#include <QMimeData>

#include "authoring/authoring.h"
#include "authoring/pieces.h"
#include "engine/workbench.h"

namespace elsie::desktop {
namespace {

constexpr auto kMime = "application/x-elsie-element";
constexpr double kAside_m = 0.3;  // how far from its original a copy stands

}  // namespace

// In the order of the world, without those that are in others of them.
QStringList Authoring::wholes() const {
  QStringList paths;
  visit(workbench_.tree(), [&](const ElementPlace& place) {
    const bool is_chosen = place.list.isEmpty() && selection_.contains(place.path);
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
  // From the back: an edit may change how those after it are called.
  for (auto path = paths.rbegin(); path != paths.rend(); ++path) {
    edits << *path + "/@remove=true";
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits, paths.size() == 1
                               ? tr("delete %1").arg(title(paths.front()))
                               : tr("delete %n things", nullptr, static_cast<int>(paths.size())));
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
  QApplication::clipboard()->setMimeData(held);
}

void Authoring::cut_selected() {
  copy_selected();
  remove_selected();
}

void Authoring::paste() {
  const QMimeData* held = QApplication::clipboard()->mimeData();
  insert(held->hasFormat(kMime) ? QString::fromUtf8(held->data(kMime)) : held->text(), tr("paste"));
}

void Authoring::duplicate_selected() { insert(markup_of_selected(), tr("duplicate")); }

// Of a piece that does not say in which list it is.
QString Authoring::list_for(const QString& name) const {
  for (const char* list : {"robots", "obstacles", "resources", "chargers", "teams", "goals",
                           "measures", "sensors", "behaviors", "coordinator"}) {
    for (const Kind& each : workbench_.catalog().members(list)) {
      if (each.name == name) {
        return list;
      }
    }
  }
  return {};
}

// The chosen thing if it may hold elements of that name, or the one in which it is; none: neither.
std::optional<QString> Authoring::holder_of_part(const QString& name) const {
  for (QString path = selection_.value(0); !path.isEmpty(); path = holder_of(path)) {
    const auto kind = workbench_.catalog().kind_of(place_of(workbench_.tree(), path));
    if (kind && kind->elements.contains(name) && member_word(name).isEmpty()) {
      return path;
    }
  }
  return std::nullopt;
}

// The chosen behaviour if it holds others, or the chosen robot; "": none is chosen.
QString Authoring::carrier(const QString& list) const {
  const QString chosen = selection_.value(0);
  const auto kind = workbench_.catalog().kind_of(place_of(workbench_.tree(), chosen));
  const bool holds = kind && kind->holds_behaviors && chosen.contains("/behavior[");
  return holds && (list == "behaviors" || list == "coordinator") ? chosen : robot();
}

void Authoring::insert(const QString& markup, const QString& name) {
  const std::vector<Piece> pieces = pieces_of(markup);
  if (pieces.empty()) {
    Q_EMIT said(tr("There is nothing to paste: copy elements of a world first."));
    return;
  }
  QStringList edits, taken;
  for (const Piece& piece : pieces) {
    QString why;
    const QString edit = insertion_of(piece, taken, why);
    if (edit.isEmpty()) {
      Q_EMIT said(why);
      return;
    }
    edits << edit;
  }
  workbench_.edit(edits, name);
}

QString Authoring::insertion_of(Piece piece, QStringList& taken, QString& why) const {
  const auto stand_aside = [&piece] {
    piece.markup =
        with_attribute(piece, "x", number(attribute_of(piece, "x").toDouble() + kAside_m));
  };
  if (const auto holder = piece.list.isEmpty() ? holder_of_part(piece.name) : std::nullopt) {
    if (piece.name == "waypoint") stand_aside();
    return *holder + '/' + piece.name + "[+]=" + piece.markup;
  }
  const QString list = piece.list.isEmpty() ? list_for(piece.name) : piece.list;
  if (list.isEmpty()) {
    why = tr("'%1' is no element that can be pasted into a world.").arg(piece.name);
    return {};
  }
  const bool is_carried =
      list == "sensors" || list == "behaviors" || list == "coordinator" || list == "drive";
  const QString holder = is_carried ? carrier(list) : QString();
  if (is_carried && holder.isEmpty()) {
    why = tr("Choose the robot that '%1' is for.").arg(piece.name);
    return {};
  }
  const QString place = (is_carried ? holder + '/' : QString()) + member_word(list);
  if (list == "coordinator" || list == "drive") {  // there is one: it is replaced
    const bool is_there = place_of(workbench_.tree(), place).element != nullptr;
    return place + (is_there ? "=" : "[+]=") + piece.markup;
  }
  // Its id is in use and its place is taken: it gets a new id and stands aside.
  const QString id = piece.name == "robot" ? free_id(workbench_.tree(), "r", taken) : QString();
  taken << id;
  piece.markup = with_attribute(piece, "id", id);
  if (kPlaced.contains(list)) stand_aside();
  return place + "[+]=" + piece.markup;
}

}  // namespace elsie::desktop
