#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "export/exporter.h"
#include "export/sharer.h"
#include "look/icons.h"
#include "main_window.h"
#include "new_world.h"
#include "scene/scene_view.h"
#include "shortcuts.h"
#include "start_page.h"
#include "text/problems_panel.h"

// The window's actions, menus and tool bars.

namespace elsie::desktop {

namespace {

QKeySequence key(const char* keys) { return QKeySequence(QString(keys)); }

/// Does what the menu key does, which not all keyboards have and Qt does not do on X11.
void open_context_menu() {
  if (QWidget* const in = QApplication::focusWidget()) {
    const QPoint at = in->inputMethodQuery(Qt::ImCursorRectangle).toRect().center();
    QContextMenuEvent wish(QContextMenuEvent::Keyboard, at, in->mapToGlobal(at));
    QApplication::sendEvent(in, &wish);
  }
}

}  // namespace

QAction* MainWindow::command(QMenu* menu, QActionGroup* group, const char* name,
                             const QString& text, const QKeySequence& key,
                             std::function<void()> does, const QString& tip) {
  auto* made = new QAction(text, this);
  made->setObjectName(name);
  made->setIcon(icon(made->objectName().remove("add_")));
  made->setShortcut(key);
  if (!tip.isEmpty()) {
    made->setToolTip(tip);
    made->setStatusTip(tip);
  }
  connect(made, &QAction::triggered, this, std::move(does));
  addAction(made);
  commands_ << made;
  if (group) group->addAction(made);
  if (menu) menu->addAction(made);
  return made;
}

/// Its key acts only where the view, or a tree that has the action, has the keyboard.
QAction* MainWindow::local(QAction* action, Qt::ShortcutContext context) {
  action->setShortcutContext(context);
  removeAction(action);
  scene_->addAction(action);
  return action;
}

void MainWindow::make_menus() {
  for (QActionGroup** group : {&with_world_, &with_text_}) {
    *group = new QActionGroup(this);
    (*group)->setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
  }
  tools_ = addToolBar(tr("Tools"));
  tools_->setObjectName("tools");
  environment_ = addToolBar(tr("Environment"));
  environment_->setObjectName("environment");
  fill_file_menu(menuBar()->addMenu(tr("&File")));
  fill_edit_menu(menuBar()->addMenu(tr("&Edit")));
  fill_view_menu(menuBar()->addMenu(tr("&View")));
  fill_simulation_menu(menuBar()->addMenu(tr("&Simulation")));
  fill_help_menu(menuBar()->addMenu(tr("&Help")));
  command(nullptr, with_text_, "next_problem", tr("Next error"), key("F8"),
          [this] { problems_->next(); });
  command(nullptr, nullptr, "context_menu", tr("Context menu"), key("Shift+F10"),
          open_context_menu);
  fill_tool_bars();
  load_shortcuts(commands_);
}

void MainWindow::fill_file_menu(QMenu* menu) {
  actions_.new_world = command(
      menu, nullptr, "new", tr("&New world"), QKeySequence::New, [this] { begin_world(new_world); },
      tr("A room in which a robot collects four resources"));
  actions_.new_world->setIconText(tr("New"));
  actions_.open = command(menu, nullptr, "open", tr("&Open..."), QKeySequence::Open, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Open a world, a recording or a run of a database"),
                                     QFileInfo(workbench_.file()).path(),
                                     tr("Worlds and runs (*.xml *.mcap *.sqlite);;All files (*)"));
    if (!file.isEmpty()) open(file);
  });
  recent_ = menu->addMenu(icon("recent"), tr("Recent&ly opened"));
  command(menu, with_text_, "start_page", tr("Start &page"), {}, [this] { show_start(); });
  menu->addSeparator();
  actions_.save =
      command(menu, with_text_, "save", tr("&Save"), QKeySequence::Save, [this] { save(false); });
  command(menu, with_text_, "save_as", tr("Save &as..."), key("Ctrl+Shift+S"),
          [this] { save(true); });
  menu->addSeparator();
  command(menu, with_world_, "export_picture", tr("Export p&icture..."), {}, [this] {
    exporter_->export_picture();
  })->setIcon(icon("picture"));
  command(
      menu, with_world_, "export_film", tr("Export &film..."), {},
      [this] { exporter_->export_film(); }, tr("Writes the run, from its start to now, as a film"));
  command(
      menu, with_world_, "share", tr("S&hare as a page..."), {},
      [this] { sharer_->share(recorded()); },
      tr("Writes the run as one HTML file that plays it in any browser"));
  command(
      menu, with_world_, "record", tr("&Record the next run..."), {},
      [this] { exporter_->record(); },
      tr("Writes it from its start into a CSV or MCAP file, 10 samples per simulated second"));
  command(menu, with_world_, "copy_command", tr("&Copy the command line that repeats this"), {},
          [this] { exporter_->copy_command(); });
  menu->addSeparator();
  command(menu, nullptr, "quit", tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::fill_edit_menu(QMenu* menu) {
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key,
                       std::function<void()> does, const QString& tip = {}) {
    return command(menu, with_world_, name, text, key, std::move(does), tip);
  };
  // The texts of Undo and Redo name the change, which would move all buttons after them on the tool
  // bar.
  actions_.undo = command(menu, nullptr, "undo", tr("&Undo"), QKeySequence::Undo,
                          [this] { workbench_.undo(); });
  actions_.undo->setIconText(tr("Undo"));
  actions_.redo = command(menu, nullptr, "redo", tr("&Redo"), key("Ctrl+Shift+Z"),
                          [this] { workbench_.redo(); });
  actions_.redo->setIconText(tr("Redo"));
  menu->addSeparator();
  // These keys act in trees and the view; a text has its own.
  const auto own = Qt::WidgetWithChildrenShortcut;
  actions_.cut =
      local(add("cut", tr("Cu&t"), QKeySequence::Cut, [this] { authoring_->cut_selected(); }), own);
  actions_.copy = local(
      add("copy", tr("&Copy"), QKeySequence::Copy, [this] { authoring_->copy_selected(); }), own);
  actions_.paste =
      local(add("paste", tr("&Paste"), QKeySequence::Paste, [this] { authoring_->paste(); }), own);
  add("duplicate", tr("&Duplicate"), key("Ctrl+D"), [this] { authoring_->duplicate_selected(); });
  actions_.remove = local(
      add("delete", tr("De&lete"), QKeySequence::Delete, [this] { authoring_->remove_selected(); }),
      own);
  menu->addSeparator();
  local(add("edit", tr("&Edit..."), key("Return"), [this] { authoring_->edit_selected(); }), own);
  add("rename", tr("Re&name..."), key("F2"), [this] { authoring_->rename_selected(); });
  add("more", tr("&More for the selection..."), {},
      [this] { authoring_->open_menu(authoring_->selection().value(0), QCursor::pos()); });
  add(
      "start_pose", tr("Make &start pose"), {}, [this] { authoring_->make_start_poses(); },
      tr("The selected robots begin where they are now"));
  actions_.lock = add("lock", tr("Loc&k against the mouse"), key("Ctrl+L"),
                      [this] { scene_->toggle_locked(authoring_->selection()); });
  menu->addSeparator();
  fill_add_menu(menu->addMenu(tr("&Add")));
}

void MainWindow::fill_add_menu(QMenu* menu) {
  menu->setObjectName("add_menu");
  const auto add = [&](const char* name, const QString& text, std::function<void()> does,
                       const QString& tip = {}) {
    return command(menu, with_world_, name, text, {}, std::move(does), tip);
  };
  const auto member = [&](const char* name, const QString& text, const char* list) {
    return add(name, text, [this, list] { authoring_->add_element({}, list); });
  };
  actions_.add_robot = member("add_robot", tr("&Robot..."), "robots");
  actions_.add_sensor = add(
      "add_sensor", tr("Se&nsor..."),
      [this] { authoring_->add_element(authoring_->robot(), "sensors"); },
      tr("Add a sensor to the selected robot"));
  actions_.behaviors = add(
      "behaviors", tr("&Behaviours..."),
      [this] { authoring_->edit_behaviors(authoring_->robot()); },
      tr("Choose the behaviours of the selected robot"));
  actions_.behaviors->setIcon(icon("behavior"));
  actions_.coordinator = add(
      "coordinator", tr("C&oordinator..."),
      [this] { authoring_->add_element(authoring_->robot(), "coordinator"); },
      tr("Choose or edit the coordinator of the selected robot"));
  add(
      "write_behavior", tr("Ne&w behaviour..."), [this] { write_behavior(); },
      tr("Writes a behaviour in C++ or Python, loads it, and opens its source"));
  menu->addSeparator();
  for (const Authoring::Obstacle& each : Authoring::obstacles()) {
    QString title = each.text + "...";
    const int first = title.startsWith('&') ? 1 : 0;
    title[first] = title[first].toUpper();
    actions_.obstacles << add(("add_" + each.name).toUtf8().constData(), title,
                              [this, kind = each.kind] {
                                authoring_->add_element({}, "obstacles", {kind, {}, {}});
                              });
  }
  actions_.add_resource = member("add_resource", tr("R&esource..."), "resources");
  actions_.add_charger = member("add_charger", tr("&Charger..."), "chargers");
  actions_.add_nest = member("add_nest", tr("Nest..."), "nests");
  actions_.add_lamp = member("add_lamp", tr("&Lamp..."), "lamps");
  actions_.add_patch = member("add_patch", tr("&Patch of the floor..."), "patches");
  menu->addSeparator();
  member("add_goal", tr("&Goal..."), "goals");
  member("add_measure", tr("Meas&ure..."), "measures");
  member("add_rule", tr("Rule..."), "rules");
  member("add_team", tr("&Team..."), "teams");
  member("add_field", tr("&Field..."), "fields");
}

void MainWindow::fill_view_menu(QMenu* menu) {
  // These keys act only in the view: elsewhere users type them, and Home goes to the first row.
  const auto in_view = [&](const char* name, const QString& text, const char* keys,
                           std::function<void()> does) {
    return local(command(menu, with_world_, name, text, key(keys), std::move(does)),
                 Qt::WidgetShortcut);
  };
  in_view("view_all", tr("Show &all"), "Home", [this] { scene_->show_all(); });
  in_view("frame", tr("Go &near to the selection"), "F", [this] { scene_->frame_selection(); });
  in_view("view_top", tr("From the &top"), "7", [this] { scene_->look(OrbitCamera::kFromTop); });
  in_view("view_front", tr("From the &front"), "1",
          [this] { scene_->look(OrbitCamera::kFromFront); });
  in_view("view_side", tr("From the &side"), "3", [this] { scene_->look(OrbitCamera::kFromSide); });
  in_view("view_isometric", tr("Obli&quely (isometric)"), "9",
          [this] { scene_->look(OrbitCamera::kIsometric); });
  // The same command again stops it.
  const auto follow = [this](SceneView::Follow how) {
    const bool stops = !scene_->followed().isEmpty() && scene_->follows() == how;
    scene_->follow(stops ? QString() : authoring_->robot(), how);
  };
  in_view("follow", tr("F&ollow the selected robot"), "Shift+F",
          [follow] { follow(SceneView::Follow::above); });
  in_view("follow_behind", tr("Follow it from &behind"), "B",
          [follow] { follow(SceneView::Follow::behind); });
  in_view("robot_eye", tr("From the robot's &place"), "0",
          [follow] { follow(SceneView::Follow::eye); });
  actions_.measure = in_view("measure", tr("&Measuring tape"), "M", [this] {
    scene_->set_tool(scene_->tool() == SceneView::Tool::measure ? SceneView::Tool::move
                                                                : SceneView::Tool::measure);
  });
  actions_.measure->setIconText(tr("Tape"));
  actions_.measure->setIcon(icon("tape"));
  menu->addSeparator();
  const auto overlay = [&](const char* name, const QString& text,
                           bool SceneView::Overlays::*which) {
    QAction* made = command(menu, nullptr, name, text, {}, [this, which] {
      scene_->overlays().*which = !(scene_->overlays().*which);
      scene_->update();
      request_past();
    });
    made->setCheckable(true);
    made->setChecked(scene_->overlays().*which);
  };
  overlay("show_trails", tr("Tra&jectories"), &SceneView::Overlays::trails);
  overlay("show_sketches", tr("S&ketches of plugins"), &SceneView::Overlays::sketches);
  overlay("show_names", tr("Nam&es"), &SceneView::Overlays::names);
  overlay("show_grid", tr("&Grid"), &SceneView::Overlays::grid);
  command(menu, with_world_, "clear_trails", tr("&Clear trajectories"), {},
          [this] { scene_->begin_trails_at(scene_->stage().time_s()); });
  menu->addSeparator();
  actions_.status_bar = new QAction(this);
  actions_.status_bar->setCheckable(true);
  actions_.status_bar->setChecked(true);
  connect(actions_.status_bar, &QAction::toggled, statusBar(), &QStatusBar::setVisible);
  const auto bar = [menu](const char* name, const QString& text, QAction* toggle) {
    toggle->setObjectName(name);
    toggle->setText(text);
    menu->addAction(toggle);
  };
  bar("show_control_bar", tr("Contro&l bar"), tools_->toggleViewAction());
  bar("show_environment_bar", tr("Env&ironment bar"), environment_->toggleViewAction());
  bar("show_status_bar", tr("Stat&us bar"), actions_.status_bar);
  menu->addSeparator();
  fill_looks_menus(menu);
  QMenu* windows = menu->addMenu(icon("window"), tr("Win&dows"));
  connect(windows, &QMenu::aboutToShow, this, [this, windows] {
    windows->clear();
    for (QDockWidget* each : docks()) {
      windows->addAction(each->toggleViewAction());
    }
  });
  command(menu, nullptr, "layout_author", tr("Layout: aut&hor"), {}, [this] { arrange("author"); });
  command(menu, nullptr, "layout_watch", tr("Layout: &watch"), {}, [this] { arrange("watch"); });
  command(menu, nullptr, "layout_train", tr("Layout: t&rain"), {}, [this] { arrange("train"); });
  command(menu, nullptr, "layout_reset", tr("Reset the la&yout"), {}, [this] { reset_layout(); });
  command(menu, nullptr, "next_dock", tr("Next window"), key("F6"), [this] { go_to_next_dock(); });
}

void MainWindow::fill_simulation_menu(QMenu* menu) {
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key,
                       std::function<void()> does, const QString& tip = {}) {
    return command(menu, with_world_, name, text, key, std::move(does), tip);
  };
  actions_.run = add("run", tr("&Run or pause"), key("F5"), [this] { run_or_pause(); });
  actions_.step = add("step", tr("&Step"), key("F10"), [this] { workbench_.step(); });
  actions_.reset =
      add("reset", tr("R&eset"), key("Ctrl+R"), [this] { workbench_.reset(workbench_.seed()); });
  add(
      "show_end", tr("Sho&w the end of the run"), {}, [this] { show_end(); },
      tr("Outcome, collected, distance, collisions, state hash, and why it failed"));
  menu->addSeparator();
  QMenu* events = menu->addMenu(tr("&Go to an event"));
  events->setObjectName("events_menu");
  connect(events, &QMenu::aboutToShow, this, [this, events] { list_events(events); });
  add("event_before", tr("Pre&vious event"), {}, [this] { time_line_->go_to_event(false); });
  add("event_after", tr("Ne&xt event"), {}, [this] { time_line_->go_to_event(true); });
  add("now", tr("Back to &now"), {}, [this] { time_line_->go_to_now(); });
  menu->addSeparator();
  add(
      "physics", tr("&Physics parameters..."), {}, [this] { authoring_->edit_element("physics"); },
      tr("Gravity, ERP and CFM or kp and kd, and the time step; also during a run"));
  add("arena", tr("&Arena..."), {}, [this] { authoring_->edit_element("arena"); });
  add("floor", tr("&Floor..."), {}, [this] { authoring_->edit_element("floor"); });
  add("limits", tr("&Limits..."), {}, [this] { authoring_->edit_element("limits"); });
  menu->addSeparator();
  command(
      menu, nullptr, "stop_engine", tr("S&top the engine now"), {},
      [this] { workbench_.stop_engine(); },
      tr("For a plugin that does not return: the engine starts again, and the world stays"));
}

void MainWindow::fill_help_menu(QMenu* menu) {
  command(menu, nullptr, "tutorial", tr("&Tutorial"), {},
          [this] { open_page("tutorial/1-your-first-behavior.md"); });
  command(
      menu, with_world_, "page_of_selected", tr("&Page of the selection"), {},
      [this] { open_page_of_selected(); },
      tr("The page of the documentation about the selected behaviour, coordinator or sensor"));
  menu->addSeparator();
  command(menu, nullptr, "commands", tr("&Commands..."), key("Ctrl+Shift+P"), [this] {
    ask_for_command();
  })->setIcon(icon("command"));
  command(menu, nullptr, "keys", tr("&Keys"), key("F1"), [this] { show_keys(); });
  command(
      menu, nullptr, "shortcuts", tr("C&hange keys..."), {},
      [this] { (new ShortcutsDialog(commands_, this))->show(); }, tr("The keys of all commands"));
  command(menu, nullptr, "about", tr("&About"), {}, [this] { about(); });
}

void MainWindow::make_status_bar() {
  const auto label = [this](const char* name) {
    auto* made = new QLabel;
    made->setObjectName(name);
    statusBar()->addPermanentWidget(made);
    return made;
  };
  recording_label_ = label("recording");
  time_label_ = label("time_s");
  pace_label_ = label("pace");
  seed_label_ = label("seed_shown");
  outcome_label_ = label("outcome");
}

void MainWindow::go_to_next_dock() {
  QList<QDockWidget*> shown;
  for (QDockWidget* each : docks()) {
    if (each->isVisible()) shown << each;
  }
  if (shown.isEmpty()) {
    return;
  }
  // raise() changes the order of the children.
  std::sort(shown.begin(), shown.end(), [](const QDockWidget* a, const QDockWidget* b) {
    return a->objectName() < b->objectName();
  });
  const QWidget* focus = QApplication::focusWidget();
  const auto now = std::find_if(shown.begin(), shown.end(), [focus](const QDockWidget* each) {
    return focus && each->isAncestorOf(focus);
  });
  QDockWidget* next = now == shown.end() || now + 1 == shown.end() ? shown.front() : *(now + 1);
  next->raise();
  if (next->widget()) next->widget()->setFocus();
}

void MainWindow::show_keys() {
  QStringList cells;
  for (const QAction* each : std::as_const(commands_)) {
    if (!each->shortcut().isEmpty()) {
      const QString key = each->shortcut().toString(QKeySequence::NativeText);
      cells << "<td style='white-space:pre'>" + key.toHtmlEscaped() +
                   "  </td><td style='white-space:pre'>" +
                   title_of(*each).section(": ", 0, 0).toHtmlEscaped() +  // without what is undone
                   "    </td>";
    }
  }
  cells.sort();
  QString rows;  // two columns: one is higher than a small screen
  const qsizetype half = (cells.size() + 1) / 2;
  for (qsizetype i = 0; i < half; ++i) {
    rows += "<tr>" + cells[i] + cells.value(half + i) + "</tr>";
  }
  const QString text =
      "<table>" + rows + "</table>" +
      tr("<p>In the view: the left button orbits, the right one pans, the wheel zooms; a "
         "click selects, with Shift several; a right click edits. "
         "Ctrl and a button always move the camera. Dragging the selected object moves it, its "
         "handles turn and resize it; Ctrl snaps, Shift refines. "
         "Arrow keys move the selection, with Shift by 1 cm. Space runs and pauses. G moves, R "
         "turns, S resizes: "
         "then X or Y, a number (m, degrees, a factor), and Enter; or the mouse.</p>"
         "<p>On the time line: Left and Right by 0.1 s, with Shift by 1 s; comma and period "
         "to the previous and next event; Home and End to the start and to now.</p>");
  QMessageBox box(QMessageBox::NoIcon, tr("Keys"), text, QMessageBox::Close, this);
  box.exec();
}

}  // namespace elsie::desktop
