#include "authoring/authoring.h"

#include <QApplication>
#include <QClipboard>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "elsie/api/geometry.h"
#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/shapes/shape.h"

#include "authoring/pieces.h"
#include "engine/workbench.h"
#include "scene/scene_view.h"
#include "world/behaviors_dialog.h"
#include "world/element_dialog.h"

namespace elsie::desktop {
namespace {

QString heading_deg(double rad) { return number(degrees(wrap_angle(rad)), 0.01); }

/// The place nearest to the middle that is free now and at the start, on rings around it; the
/// middle if there is none.
QPointF free_place(const Stage& stage, const Json& world) {
  constexpr double kRoom = 0.3;   // m, around it
  constexpr double kStep = 0.25;  // m, between rings
  const double half = 0.5 * std::min(stage.length(), stage.width()) - kRoom;
  for (int ring = 0; ring * kStep <= std::max(0.0, half); ++ring) {
    const int places = ring == 0 ? 1 : 8 * ring;
    for (int i = 0; i < places; ++i) {
      const double angle = 2.0 * M_PI * i / places;
      const QPointF at(ring * kStep * std::cos(angle), ring * kStep * std::sin(angle));
      if (stage.is_free(at, kRoom) && is_free_at_start(world, at, kRoom)) {
        return at;
      }
    }
  }
  return {};
}

/// Brings the first open one of these dialogs that `is_it` to the front; false if there is none.
template <class Dialog, class Is>
bool has_raised(const QWidget* window, const Is& is_it) {
  for (Dialog* each : window->findChildren<Dialog*>()) {
    if (each->isHidden() || !is_it(*each)) continue;  // one is deleted some time after it closes
    each->raise();
    each->activateWindow();
    return true;
  }
  return false;
}

}  // namespace

std::vector<Authoring::Obstacle> Authoring::obstacles() {
  std::vector<Obstacle> all{{"static", "static_box", tr("&static box")},
                            {"dynamic", "dynamic_box", tr("&dynamic box")},
                            {"moving", "moving_box", tr("&moving box")}};
  QString taken = "bcdefglmnoprstu";
  for (const QString shape : kBoxShapes) {
    if (shape == "box") continue;
    QString text = tr(shape.toUtf8().constData());
    const auto letter = std::find_if(
        text.begin(), text.end(), [&](QChar one) { return one.isLower() && !taken.contains(one); });
    if (letter != text.end()) {
      taken += *letter;
      text.insert(letter - text.begin(), '&');
    }
    all.push_back({shape, "static_" + shape, text});
  }
  return all;
}

Authoring::Authoring(Workbench& workbench, SceneView& view, QWidget* window)
    : QObject(window), workbench_(workbench), view_(view), stage_(view.stage()), window_(window) {
  connect(&workbench_, &Workbench::described, this, &Authoring::find_renamed);
  connect(&view_, &SceneView::said, this, &Authoring::said);
  connect(&view_, &SceneView::selected, this, &Authoring::select);
  connect(&view_, &SceneView::edit_wished, this, &Authoring::edit_element);
  connect(&view_, &SceneView::menu_wished, this, &Authoring::open_floor_menu);
  connect(&view_, &SceneView::element_menu_wished, this, &Authoring::open_menu);
  connect(&view_, &SceneView::moved, this, &Authoring::move);
  connect(&view_, &SceneView::turned, this, &Authoring::turn);
  connect(&view_, &SceneView::resized, this, &Authoring::resize);
}

// The selection stays when its paths change: by a form, by undo, in the text.
void Authoring::find_renamed() {
  const Outline before = std::exchange(outline_, outline_of(workbench_.tree()));
  const QHash<QString, QString> names = renamed(before, outline_);
  for (auto name = names.begin(); name != names.end(); ++name) {
    view_.rename(name.key(), name.value());
    Q_EMIT called_otherwise(name.key(), name.value());
  }
  QStringList paths = selection_;
  for (QString& path : paths) {
    path = names.value(path, path);
  }
  if (paths != selection_) {
    select(paths);
  }
}

QString Authoring::title(const QString& path) const { return title_at(workbench_.tree(), path); }

void Authoring::select(const QStringList& paths) {
  selection_ = paths;
  QStringList in_view = paths;
  in_view.removeAll(QString());  // the world itself has no place
  view_.set_selection(in_view);
  Q_EMIT selected(paths);
}

QString Authoring::robot() const { return robot_path(selection_.value(0)); }

// Dialogs and menus

bool Authoring::has_raised_editor(const QString& path) {
  return has_raised<ElementDialog>(
      window_, [&](const ElementDialog& each) { return each.is_editor_of(path); });
}

bool Authoring::has_raised_behaviors(const QString& holder) {
  return has_raised<BehaviorsDialog>(
      window_, [&](const BehaviorsDialog& each) { return each.holder() == holder; });
}

void Authoring::close_dialogs() {
  for (QDialog* each : window_->findChildren<QDialog*>()) {
    const bool edits = qobject_cast<ElementDialog*>(each) || qobject_cast<BehaviorsDialog*>(each);
    if (edits && !each->isHidden()) each->done(QDialog::Rejected);
  }
}

void Authoring::edit_element(const QString& path) {
  if (has_raised_editor(path)) {
    return;
  }
  QString why;
  if (ElementDialog* dialog = ElementDialog::edit(workbench_, path, window_, why)) {
    connect(this, &Authoring::called_otherwise, dialog, &ElementDialog::rename);
    dialog->show();
  } else {
    Q_EMIT said(why);
  }
}

void Authoring::edit_selected() {
  if (!selection_.isEmpty()) {
    edit_element(selection_.front());
  }
}

void Authoring::add_element(const QString& holder, const QString& list,
                            const Beginning& beginning) {
  if (!workbench_.tree().is_object()) {
    Q_EMIT said(tr("There is no world to add to: open one, or make a new one."));
    return;
  }
  if (holder.isEmpty() &&
      (list == "sensors" || list == "actuators" || list == "behaviors" || list == "coordinator")) {
    Q_EMIT said(tr("Select the robot first."));
    return;
  }
  if (list == "coordinator" && has_raised_editor(holder + "/coordinator")) {
    Q_EMIT said(tr("The coordinator of %1 is being edited in this dialog.").arg(title(holder)));
    return;
  }
  ElementDialog* dialog = ElementDialog::make(workbench_, holder, list, window_);
  connect(this, &Authoring::called_otherwise, dialog, &ElementDialog::rename);
  if (list == "robots") {
    dialog->begin_with("id", free_id(workbench_.tree(), "r"));
  }
  if (list == "teams") {
    dialog->begin_with("id", free_id(workbench_.tree(), "team"));
  }
  if (list == "fields") {
    dialog->begin_with("id", free_id(workbench_.tree(), "field"));
  }
  if (!beginning.team.isEmpty()) {
    dialog->begin_with("team", beginning.team);
  }
  const QPointF at = beginning.at.value_or(
      kPlaced.contains(list) ? free_place(stage_, workbench_.tree()) : QPointF());
  if (beginning.at || !at.isNull()) {
    dialog->begin_with("x", number(at.x(), 0.01));
    dialog->begin_with("y", number(at.y(), 0.01));
  }
  if (!beginning.kind.isEmpty()) {
    dialog->choose(beginning.kind);
  }
  // The new element is selected next: it is the last of its list, or of its name.
  connect(dialog, &QDialog::accepted, this, [this, holder, list, dialog] {
    const ElementPlace around = list.isEmpty() ? place_of(workbench_.tree(), holder)
                                               : list_at(workbench_.tree(), holder, list);
    QString path;
    if (around.element) {
      visit_children(around, [&](const ElementPlace& each) {
        if (!list.isEmpty() || name_of(*each.element) == dialog->kind()) path = each.path;
      });
    }
    if (!path.isEmpty()) {
      select({path});
      view_.setFocus();  // so that keys act on it
    }
  });
  dialog->show();
}

std::vector<QPointF> Authoring::places_in(const QString& path, const QString& name) const {
  std::vector<QPointF> places;
  visit_children(place_of(workbench_.tree(), path), [&](const ElementPlace& each) {
    if (name_of(*each.element) == name) {
      places.emplace_back(attribute(*each.element, "x").toDouble(),
                          attribute(*each.element, "y").toDouble());
    }
  });
  return places;
}

// Its numbers are then in Properties.
void Authoring::add_place(const QString& path, const QString& name, const QPointF& at) {
  const auto number_of_it = places_in(path, name).size() + 1;
  const QString list = path + '/' + name;
  workbench_.edit({QString("%1[+]=<%2 x=\"%3\" y=\"%4\"/>")
                       .arg(list, name, number(at.x(), 1e-4), number(at.y(), 1e-4))},
                  tr("add %1").arg(name), {}, this,
                  [this, list, number_of_it](const Problems& problems) {
                    problems.empty() ? select({QString("%1[%2]").arg(list).arg(number_of_it)})
                                     : Q_EMIT said(problems.front().message);
                  });
}

// Adds a waypoint next to the last one.
void Authoring::add_waypoint(const QString& path) {
  const std::vector<QPointF> places = places_in(path, "waypoint");
  add_place(path, "waypoint", (places.empty() ? QPointF() : places.back()) + QPointF(0.0, 0.5));
}

// Adds a point just outside of the middle of the last side, so that the outline stays convex.
void Authoring::add_point(const QString& path) {
  const std::vector<QPointF> places = places_in(path, "point");
  if (places.empty()) {
    return;
  }
  const QPointF side = places.front() - places.back();
  const QPointF middle =
      std::accumulate(places.begin(), places.end(), QPointF()) / static_cast<double>(places.size());
  const QPointF at = 0.5 * (places.back() + places.front());
  QPointF outwards(side.y(), -side.x());
  if (QPointF::dotProduct(outwards, at - middle) < 0.0) outwards = -outwards;
  add_place(path, "point", at + 0.02 * outwards);
}

void Authoring::edit_behaviors(const QString& holder) {
  if (holder.isEmpty()) {
    Q_EMIT said(tr("Select the robot first."));
    return;
  }
  if (has_raised_behaviors(holder)) {
    return;
  }
  auto* dialog = new BehaviorsDialog(workbench_, holder, window_);
  connect(this, &Authoring::called_otherwise, dialog, &BehaviorsDialog::rename);
  dialog->show();
}

void Authoring::open_menu(const QString& path, const QPoint& global) {
  if (path.isEmpty()) {
    open_floor_menu(global);
    return;
  }
  if (!selection_.contains(path)) {
    select({path});
  }
  QMenu menu(window_);
  menu.setObjectName("element_menu");
  const ElementPlace place = place_of(workbench_.tree(), path);
  menu.addAction(tr("&Edit..."), this, [this, path] { edit_element(path); });
  const auto kind = workbench_.catalog().kind_of(place);
  const bool is_robot = kind && kind->name == "robot";
  if (is_robot) {
    menu.addAction(tr("Add &sensor..."), this, [this, path] { add_element(path, "sensors"); });
    menu.addAction(tr("Add &actuator..."), this, [this, path] { add_element(path, "actuators"); });
  }
  if (is_robot || (kind && kind->holds_behaviors)) {
    menu.addAction(tr("&Behaviours..."), this, [this, path] { edit_behaviors(path); });
    menu.addAction(tr("&Coordinator..."), this, [this, path] { add_element(path, "coordinator"); });
  }
  if (kind && kind->is_of_plugin && !kind->elements.isEmpty()) {
    menu.addAction(tr("Add ele&ment..."), this, [this, path] { add_element(path, {}); });
  }
  if (kind && kind->elements.contains("waypoint")) {
    menu.addAction(tr("Add &waypoint"), this, [this, path] { add_waypoint(path); });
  }
  if (kind && kind->elements.contains("point")) {
    menu.addAction(tr("Add &point"), this, [this, path] { add_point(path); });
  }
  if (is_robot) {
    menu.addAction(tr("&Follow"), this, [this, path] { view_.follow(path); });
    menu.addAction(tr("Make &start pose"), this, &Authoring::make_start_poses);
  }
  if (path.endsWith("/coordinator")) {
    menu.addAction(tr("&Replace..."), this,
                   [this, path] { add_element(holder_of(path), "coordinator"); });
  }
  menu.addSeparator();
  if (may_duplicate()) {
    menu.addAction(tr("&Duplicate"), this, &Authoring::duplicate_selected);
  }
  if (place.element && !attribute(*place.element, "weights").isEmpty()) {
    menu.addAction(tr("&Clear the network"), this, [this, path] {
      workbench_.edit({path + "/@weights/@remove=true"}, tr("clear the network"));
    });
  }
  menu.addAction(tr("De&lete"), this, &Authoring::remove_selected);
  menu.exec(global);
}

void Authoring::open_floor_menu(const QPoint& global, std::optional<QPointF> at) {
  QMenu menu(window_);
  menu.setObjectName("floor_menu");
  const auto offer = [&](const QString& text, const QString& list, const QString& kind = {}) {
    menu.addAction(text, this, [this, list, beginning = Beginning{kind, {}, at}] {
      add_element({}, list, beginning);
    });
  };
  const bool is_here = at.has_value();
  offer(is_here ? tr("Add &robot here...") : tr("Add &robot..."), "robots");
  for (const Obstacle& each : obstacles()) {
    offer((is_here ? tr("Add %1 here...") : tr("Add %1...")).arg(each.text), "obstacles",
          each.kind);
  }
  offer(is_here ? tr("Add r&esource here...") : tr("Add r&esource..."), "resources");
  offer(is_here ? tr("Add &charger here...") : tr("Add &charger..."), "chargers");
  offer(is_here ? tr("Add &nest here...") : tr("Add &nest..."), "nests");
  offer(is_here ? tr("Add &lamp here...") : tr("Add &lamp..."), "lamps");
  offer(is_here ? tr("Add &patch of the floor here...") : tr("Add &patch of the floor..."),
        "patches");
  if (!is_here) {
    offer(tr("Add &goal..."), "goals");
    offer(tr("Add meas&ure..."), "measures");
    offer(tr("Add rule..."), "rules");
    offer(tr("Add &team..."), "teams");
    offer(tr("Add &field..."), "fields");
  }
  menu.addSeparator();
  QAction* paste = menu.addAction(tr("Pas&te"), this, &Authoring::paste);
  paste->setEnabled(!pieces_of(QApplication::clipboard()->text()).empty());
  menu.exec(global);
}

void Authoring::open_list_menu(const QString& holder, const QString& list, const QPoint& global) {
  QMenu menu(window_);
  menu.setObjectName("list_menu");
  const auto offer = [&](const QString& text, const QString& kind = {}) {
    menu.addAction(text, this, [this, holder, list, beginning = Beginning{kind, {}, {}}] {
      add_element(holder, list, beginning);
    });
  };
  if (list == "behaviors") {
    menu.addAction(tr("&Behaviours..."), this, [this, holder] { edit_behaviors(holder); });
    offer(tr("&Add one with its parameters..."));
  } else if (list == "coordinator") {
    offer(tr("&Coordinator..."));
  } else if (list == "obstacles") {
    for (const Obstacle& each : obstacles()) offer(tr("Add %1...").arg(each.text), each.kind);
  } else if (!workbench_.catalog().members(list).empty()) {
    offer(tr("&Add %1...").arg(member_word(list)));
  }
  menu.addSeparator();
  QAction* paste = menu.addAction(tr("Pas&te"), this, [this, holder] {
    if (!holder.isEmpty()) select({holder});  // parts of a robot go to what is selected
    this->paste();
  });
  paste->setEnabled(may_paste_into(list));
  menu.exec(global);
}

// Changes of the selection

void Authoring::rename_selected() {
  if (selection_.isEmpty()) {
    return;
  }
  const QString path = selection_.front();
  const ElementPlace place = place_of(workbench_.tree(), path);
  const auto kind = workbench_.catalog().kind_of(place);
  const bool has_name = kind && std::any_of(kind->fields.begin(), kind->fields.end(),
                                            [](const Field& field) { return field.name == "id"; });
  if (!has_name) {
    Q_EMIT said(tr("'%1' has no name of its own.").arg(title(path)));
    return;
  }
  QInputDialog dialog(window_);
  dialog.setObjectName("rename_dialog");
  dialog.setWindowTitle(tr("Rename"));
  dialog.setLabelText(tr("Name of %1").arg(title(path)));
  dialog.setTextValue(title(path));
  if (dialog.exec() == QDialog::Accepted && !dialog.textValue().isEmpty()) {
    workbench_.edit({attribute_path(path, "id") + '=' + dialog.textValue()},
                    tr("rename %1").arg(title(path)));
  }
}

void Authoring::make_start_poses() {
  QStringList edits;
  for (const QString& path : std::as_const(selection_)) {
    const Stage::Body* body = stage_.body_of(path);
    if (body && body->is_robot()) {
      edits << path + "/@x=" + number(body->frame.origin.x)
            << path + "/@y=" + number(body->frame.origin.y)
            << path + "/@heading_deg=" + heading_deg(heading_rad(body->frame));
    }
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits, tr("make start pose"));
  }
}

// Drags

bool Authoring::is_the_present() {
  if (stage_.is_past()) Q_EMIT moved_in_the_past();
  return !stage_.is_past();
}

void Authoring::move(const QStringList& paths, double by_x, double by_y) {
  if (!is_the_present()) return;
  QStringList edits;
  for (const QString& path : paths) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    if (!place.element) {
      continue;
    }
    const Stage::Body* body = stage_.body_of(path);
    const double x = body ? body->frame.origin.x : attribute(*place.element, "x").toDouble();
    const double y = body ? body->frame.origin.y : attribute(*place.element, "y").toDouble();
    edits << path + "/@x=" + number(x + by_x) << path + "/@y=" + number(y + by_y);
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits,
                    paths.size() == 1
                        ? tr("move %1").arg(title(paths.front()))
                        : tr("move %n things", nullptr, static_cast<int>(paths.size())),
                    "move " + paths.join(' '));
  }
}

void Authoring::turn(const QString& path, double by_rad) {
  const auto frame = stage_.place_of(path);
  const auto kind = workbench_.catalog().kind_of(place_of(workbench_.tree(), path));
  const bool has_heading =
      kind && std::any_of(kind->fields.begin(), kind->fields.end(),
                          [](const Field& field) { return field.name == "heading_deg"; });
  if (frame && has_heading && is_the_present()) {
    workbench_.edit({path + "/@heading_deg=" + heading_deg(heading_rad(*frame) + by_rad)},
                    tr("turn %1").arg(title(path)), "turn " + path);
  }
}

void Authoring::resize(const QString& path, double length, double width) {
  const Stage::Solid* solid = stage_.solid_of(path);
  if (!solid || !is_the_present()) {
    return;
  }
  const Shape made = resized(solid->shape, length, width);
  const ElementPlace place = place_of(workbench_.tree(), path);
  const std::map<QString, double> values{
      {"length", made.size.x}, {"radius", 0.5 * made.size.x}, {"width", made.size.y}};
  QStringList edits;
  if (const auto kind = workbench_.catalog().kind_of(place)) {
    for (const Field& field : kind->fields) {
      const auto value = values.find(field.name);
      if (value != values.end()) edits << path + "/@" + field.name + '=' + number(value->second);
    }
  }
  const double by_x = length / solid->shape.size.x, by_y = width / solid->shape.size.y;
  visit_children(place, [&](const ElementPlace& each) {
    if (name_of(*each.element) != "point") return;
    for (const auto& [name, by] : {std::pair("x", by_x), std::pair("y", by_y)}) {
      const double scaled = by * attribute(*each.element, name).toDouble();
      edits << attribute_path(each.path, name) + '=' + number(scaled, 1e-5);
    }
  });
  workbench_.edit(edits, tr("resize %1").arg(title(path)), "resize " + path);
}

}  // namespace elsie::desktop
