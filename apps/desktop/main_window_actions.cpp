#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCompleter>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
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
#include "main_window.h"
#include "scene/scene_view.h"
#include "shortcuts.h"
#include "start_page.h"
#include "text/problems_panel.h"

// The window's actions, menus and tool bars.

namespace elsie::desktop {

QAction* MainWindow::action(const QString& name, const QString& text, const QKeySequence& key,
                            std::function<void()> does, const QString& tip) {
  auto* made = new QAction(text, this);
  made->setObjectName(name);
  made->setShortcut(key);
  if (!tip.isEmpty()) {
    made->setToolTip(tip);
    made->setStatusTip(tip);
  }
  connect(made, &QAction::triggered, this, std::move(does));
  addAction(made);
  actions_[name] = made;
  return made;
}

void MainWindow::make_actions() {
  const auto key = [](const char* keys) { return QKeySequence(QString(keys)); };
  action("new", tr("&New world..."), QKeySequence::New, [this] {
    begin_world([this] { return ask_for_new_world(this); });
  })->setIconText(tr("New"));
  action("open", tr("&Open..."), QKeySequence::Open, [this] {
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Open a world, a recording or a run of a database"),
                                     QFileInfo(workbench_.file()).path(),
                                     tr("Worlds and runs (*.xml *.mcap *.sqlite);;All files (*)"));
    if (!file.isEmpty()) open(file);
  });
  action("save", tr("&Save"), QKeySequence::Save, [this] { save(false); });
  action("save_as", tr("Save &as..."), key("Ctrl+Shift+S"), [this] { save(true); });
  action("start_page", tr("Start &page"), {}, [this] { show_start(); });
  action("export_picture", tr("Export p&icture..."), {}, [this] { exporter_->export_picture(); });
  action(
      "export_film", tr("Export &film..."), {}, [this] { exporter_->export_film(); },
      tr("Writes the run, from its start to now, as a film"));
  action(
      "record", tr("&Record the next run..."), {}, [this] { exporter_->record(); },
      tr("Writes it from its start into a CSV or MCAP file, 10 samples per simulated second"));
  action("copy_command", tr("&Copy the command line that repeats this"), {},
         [this] { exporter_->copy_command(); });
  action("quit", tr("&Quit"), QKeySequence::Quit, [this] { close(); });

  // The texts of Undo and Redo name the change, which would move all buttons after them on the tool
  // bar.
  action("undo", tr("&Undo"), QKeySequence::Undo, [this] {
    workbench_.undo();
  })->setIconText(tr("Undo"));
  action("redo", tr("&Redo"), key("Ctrl+Shift+Z"), [this] {
    workbench_.redo();
  })->setIconText(tr("Redo"));
  action("cut", tr("Cu&t"), QKeySequence::Cut, [this] { authoring_->cut_selected(); });
  action("copy", tr("&Copy"), QKeySequence::Copy, [this] { authoring_->copy_selected(); });
  action("paste", tr("&Paste"), QKeySequence::Paste, [this] { authoring_->paste(); });
  action("duplicate", tr("&Duplicate"), key("Ctrl+D"),
         [this] { authoring_->duplicate_selected(); });
  action("delete", tr("De&lete"), QKeySequence::Delete, [this] { authoring_->remove_selected(); });
  action("rename", tr("Re&name..."), key("F2"), [this] { authoring_->rename_selected(); });
  action("edit", tr("&Edit..."), key("Return"), [this] { authoring_->edit_selected(); });
  // These keys act in trees and the view; a text has its own.
  for (const char* name : {"edit", "delete", "cut", "copy", "paste"}) {
    actions_[name]->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    removeAction(actions_[name]);
    scene_->addAction(actions_[name]);
  }
  action("lock", tr("Loc&k against the mouse"), key("Ctrl+L"),
         [this] { scene_->toggle_locked(authoring_->selection()); });
  action("more", tr("&More for the selection..."), {},
         [this] { authoring_->open_menu(authoring_->selection().value(0), QCursor::pos()); });
  action(
      "start_pose", tr("Make &start pose"), {}, [this] { authoring_->make_start_poses(); },
      tr("The selected robots begin where they are now"));
  action("add_robot", tr("&Robot..."), {}, [this] { authoring_->add_element({}, "robots"); });
  action(
      "add_sensor", tr("Se&nsor..."), {},
      [this] { authoring_->add_element(authoring_->robot(), "sensors"); },
      tr("Add a sensor to the selected robot"));
  action(
      "behaviors", tr("&Behaviours..."), {},
      [this] { authoring_->edit_behaviors(authoring_->robot()); },
      tr("Choose the behaviours of the selected robot"));
  action(
      "coordinator", tr("C&oordinator..."), {},
      [this] { authoring_->edit_coordinator(authoring_->robot()); },
      tr("Choose or edit the coordinator of the selected robot"));
  action("add_static", tr("&Static box..."), {}, [this] {
    authoring_->add_element({}, "obstacles", {"static_box", {}, {}});
  });
  action("add_dynamic", tr("&Dynamic box..."), {}, [this] {
    authoring_->add_element({}, "obstacles", {"dynamic_box", {}, {}});
  });
  action("add_moving", tr("&Moving box..."), {}, [this] {
    authoring_->add_element({}, "obstacles", {"moving_box", {}, {}});
  });
  for (const auto& [shape, text] : Authoring::other_shapes()) {
    QString name = text + "...";
    name[name.startsWith('&') ? 1 : 0] = name[name.startsWith('&') ? 1 : 0].toUpper();
    action("add_" + shape, name, {}, [this, kind = "static_" + shape] {
      authoring_->add_element({}, "obstacles", {kind, {}, {}});
    });
    boxes_actions_ << "add_" + shape;
  }
  action("add_resource", tr("R&esource..."), {},
         [this] { authoring_->add_element({}, "resources"); });
  action("add_charger", tr("&Charger..."), {}, [this] { authoring_->add_element({}, "chargers"); });
  action("add_goal", tr("&Goal..."), {}, [this] { authoring_->add_element({}, "goals"); });
  action("add_measure", tr("Meas&ure..."), {}, [this] { authoring_->add_element({}, "measures"); });
  action("add_team", tr("&Team..."), {}, [this] { authoring_->add_element({}, "teams"); });

  action("run", tr("&Run or pause"), key("F5"), [this] { run_or_pause(); });
  action("step", tr("&Step"), key("F10"), [this] { workbench_.step(); });
  action("reset", tr("R&eset"), key("Ctrl+R"), [this] { workbench_.reset(workbench_.seed()); });
  action("event_before", tr("Pre&vious event"), {}, [this] { time_line_->go_to_event(false); });
  action("event_after", tr("Ne&xt event"), {}, [this] { time_line_->go_to_event(true); });
  action("now", tr("Back to &now"), {}, [this] { time_line_->go_to_now(); });
  action(
      "physics", tr("&Physics parameters..."), {}, [this] { authoring_->edit_element("physics"); },
      tr("Gravity, ERP and CFM or kp and kd, and the time step; also during a run"));
  action("arena", tr("&Arena..."), {}, [this] { authoring_->edit_element("arena"); });
  action("limits", tr("&Limits..."), {}, [this] { authoring_->edit_element("limits"); });
  action(
      "stop_engine", tr("S&top the engine now"), {}, [this] { workbench_.stop_engine(); },
      tr("For a plugin that does not return: the engine starts again, and the world stays"));

  action("view_all", tr("Show &all"), key("Home"), [this] { scene_->show_all(); });
  action("frame", tr("Go &near to the selection"), key("F"), [this] { scene_->frame_selection(); });
  action("view_top", tr("From the &top"), key("7"), [this] { scene_->look_from_top(); });
  action("view_front", tr("From the &front"), key("1"), [this] { scene_->look_from_front(); });
  action("view_side", tr("From the &side"), key("3"), [this] { scene_->look_from_side(); });
  action("follow", tr("F&ollow the selected robot"), key("Shift+F"), [this] {
    scene_->follow(scene_->followed().isEmpty() ? authoring_->robot() : QString());
  });
  action("measure", tr("&Measuring tape"), key("M"), [this] {
    scene_->set_tool(scene_->tool() == SceneView::Tool::measure ? SceneView::Tool::move
                                                                : SceneView::Tool::measure);
  })->setIconText(tr("Tape"));
  // These keys act only in the view: elsewhere users type them, and Home goes to the first row.
  for (const char* name :
       {"view_all", "frame", "view_top", "view_front", "view_side", "follow", "measure"}) {
    actions_[name]->setShortcutContext(Qt::WidgetShortcut);
    removeAction(actions_[name]);
    scene_->addAction(actions_[name]);
  }
  const auto overlay = [&](const char* name, const QString& text,
                           bool SceneView::Overlays::*which) {
    QAction* made = action(name, text, {}, [this, which, name] {
      scene_->overlays().*which = actions_[name]->isChecked();
      scene_->update();
      request_past();
    });
    made->setCheckable(true);
    made->setChecked(scene_->overlays().*which);
  };
  overlay("show_trails", tr("Tra&jectories"), &SceneView::Overlays::trails);
  overlay("show_beams", tr("&Beams"), &SceneView::Overlays::beams);
  overlay("show_views", tr("Fields of &view"), &SceneView::Overlays::views);
  overlay("show_names", tr("Nam&es"), &SceneView::Overlays::names);
  overlay("show_grid", tr("&Grid"), &SceneView::Overlays::grid);
  action("clear_trails", tr("&Clear trajectories"), {},
         [this] { scene_->begin_trails_at(scene_->stage().time_s()); });
  for (const auto& [layout, text] : {std::pair{"author", tr("Layout: aut&hor")},
                                     {"watch", tr("Layout: &watch")},
                                     {"train", tr("Layout: t&rain")}}) {
    action((std::string("layout_") + layout).c_str(), text, {},
           [this, name = QString(layout)] { arrange(name); });
  }
  action("layout_reset", tr("Reset the la&yout"), {}, [this] { restoreState(default_state_); });
  action("next_problem", tr("Next error"), key("F8"), [this] { problems_->next(); });
  action("next_dock", tr("Next window"), key("F6"), [this] {
    QList<QDockWidget*> shown;
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
      if (each->isVisible()) shown << each;
    }
    // raise() changes the order of the children.
    std::sort(shown.begin(), shown.end(), [](const QDockWidget* a, const QDockWidget* b) {
      return a->objectName() < b->objectName();
    });
    if (!shown.isEmpty()) {
      QWidget* focus = QApplication::focusWidget();
      qsizetype now = -1;
      for (qsizetype i = 0; i < shown.size(); ++i) {
        if (focus && shown[i]->isAncestorOf(focus)) now = i;
      }
      QDockWidget* next = shown[(now + 1) % shown.size()];
      next->raise();
      if (next->widget()) next->widget()->setFocus();
    }
  });
  action("commands", tr("&Commands..."), key("Ctrl+Shift+P"), [this] {
    QStringList names;
    QHash<QString, QAction*> by_name;
    for (QAction* each : std::as_const(actions_)) {
      QString name = each->text().remove('&').remove("...");
      if (!each->shortcut().isEmpty())
        name += "   " + each->shortcut().toString(QKeySequence::NativeText);
      names << name;
      by_name[name] = each;
    }
    names.sort(Qt::CaseInsensitive);
    QInputDialog dialog(this);
    dialog.setObjectName("commands_dialog");
    dialog.setWindowTitle(tr("Commands"));
    dialog.setLabelText(tr("A part of the command's name"));
    dialog.setComboBoxItems(names);
    dialog.setComboBoxEditable(true);
    auto* choice = dialog.findChild<QComboBox*>();
    choice->completer()->setCompletionMode(QCompleter::PopupCompletion);
    choice->completer()->setFilterMode(Qt::MatchContains);
    choice->clearEditText();
    if (dialog.exec() == QDialog::Accepted && !dialog.textValue().isEmpty()) {
      const QString wished = dialog.textValue();
      const QStringList fitting = names.filter(wished, Qt::CaseInsensitive);
      const QString name = names.contains(wished) || fitting.size() != 1 ? wished : fitting.front();
      by_name.contains(name) ? by_name[name]->trigger()
                             : say(tr("There is no command '%1'.").arg(wished));
    }
  });
  action("keys", tr("&Keys"), key("F1"), [this] {
    QString text = "<table>";
    QStringList rows;
    for (const QAction* each : std::as_const(actions_)) {
      if (!each->shortcut().isEmpty()) {
        rows << "<tr><td>" + each->shortcut().toString(QKeySequence::NativeText) +
                    "&nbsp;&nbsp;</td><td>" +
                    each->text().remove('&').remove("...").toHtmlEscaped() + "</td></tr>";
      }
    }
    rows.sort();
    text +=
        rows.join("") + "</table>" +
        tr("<p>In the view: the left button orbits, the right one pans, the wheel zooms; a "
           "click selects, with Shift several; a right click edits. "
           "Ctrl and a button always move the camera. Handles move, turn and resize; Ctrl "
           "snaps, Shift refines. "
           "Arrow keys move the selection, with Shift by 1 cm. Space runs and pauses. G moves, R "
           "turns, S resizes: "
           "then X or Y, a number (m, degrees, a factor), and Enter; or the mouse.</p>"
           "<p>On the time line: Left and Right by 0.1 s, with Shift by 1 s; comma and period "
           "to the previous and next event; Home and End to the start and to now.</p>");
    QMessageBox box(QMessageBox::NoIcon, tr("Keys"), text, QMessageBox::Close, this);
    box.exec();
  });
  action(
      "shortcuts", tr("C&hange keys..."), {},
      [this] { (new ShortcutsDialog(actions_, this))->show(); }, tr("The keys of all commands"));
  action("about", tr("&About"), {}, [this] { about(); });
  load_shortcuts(actions_);
}

void MainWindow::make_menus() {
  const auto fill = [this](QMenu* menu, const QStringList& names) {
    for (const QString& name : names) {
      name.isEmpty() ? static_cast<void>(menu->addSeparator()) : menu->addAction(actions_[name]);
    }
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  fill(file, {"new", "open"});
  recent_ = file->addMenu(tr("Recent&ly opened"));
  fill(file, {"start_page", "", "save", "save_as", "", "export_picture", "export_film", "record",
              "copy_command", "", "quit"});
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  fill(edit, {"undo", "redo", "", "cut", "copy", "paste", "duplicate", "delete", "", "edit",
              "rename", "more", "start_pose", "lock", ""});
  QMenu* add = edit->addMenu(tr("&Add"));
  add->setObjectName("add_menu");
  fill(add,
       QStringList{"add_robot", "add_sensor", "behaviors", "coordinator", ""} + boxes_actions_ +
           QStringList{"add_resource", "add_charger", "", "add_goal", "add_measure", "add_team"});
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view,
       {"view_all", "frame", "view_top", "view_front", "view_side", "follow", "measure", "",
        "show_trails", "show_beams", "show_views", "show_names", "show_grid", "clear_trails", ""});
  QAction* const before = view->addSeparator();
  windows_ = view->addMenu(tr("Win&dows"));
  connect(windows_, &QMenu::aboutToShow, this, [this] {
    windows_->clear();
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
      windows_->addAction(each->toggleViewAction());
    }
  });
  fill(view, {"layout_author", "layout_watch", "layout_train", "layout_reset", "next_dock"});
  QMenu* simulation = menuBar()->addMenu(tr("&Simulation"));
  fill(simulation, {"run", "step", "reset", ""});
  QMenu* events = simulation->addMenu(tr("&Go to an event"));
  events->setObjectName("events_menu");
  connect(events, &QMenu::aboutToShow, this, [this, events] { list_events(events); });
  fill(simulation,
       {"event_before", "event_after", "now", "", "physics", "arena", "limits", "", "stop_engine"});
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  fill(help, {"commands", "keys", "shortcuts", "about"});

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  for (const char* name : {"new", "open", "save"}) bar->addAction(actions_[name]);
  bar->addSeparator();
  for (const char* name : {"undo", "redo"}) bar->addAction(actions_[name]);
  bar->addSeparator();
  control_bar_ = new ControlBar(workbench_);
  connect(control_bar_, &ControlBar::run_wished, this, &MainWindow::run_or_pause);
  connect(control_bar_, &ControlBar::seed_wished, this, &MainWindow::begin_anew);
  bar->addWidget(control_bar_);
  QToolBar* environment = addToolBar(tr("Environment"));
  environment->setObjectName("environment");
  const auto offer = [view, before](const char* name, const QString& text, QAction* toggle) {
    toggle->setObjectName(name);
    toggle->setText(text);
    view->insertAction(before, toggle);
  };
  offer("show_control_bar", tr("Contro&l bar"), bar->toggleViewAction());
  offer("show_environment_bar", tr("Env&ironment bar"), environment->toggleViewAction());
  auto* status = new QAction(this);
  status->setCheckable(true);
  status->setChecked(true);
  connect(status, &QAction::toggled, statusBar(), &QStatusBar::setVisible);
  offer("show_status_bar", tr("Stat&us bar"), status);
  for (const char* name : {"add_robot", "add_sensor", "behaviors", "coordinator"}) {
    environment->addAction(actions_[name]);
  }
  boxes_ = new QToolButton;
  boxes_->setObjectName("boxes");
  boxes_->setText(tr("Box"));
  boxes_->setToolTip(tr("Add a static, dynamic or moving box, or another obstacle"));
  boxes_->setPopupMode(QToolButton::InstantPopup);
  for (const QString& name : boxes_actions_) boxes_->addAction(actions_[name]);
  environment->addWidget(boxes_);
  for (const char* name : {"add_resource", "add_charger", "measure"}) {
    environment->addAction(actions_[name]);
  }

  time_label_ = new QLabel;
  time_label_->setObjectName("time_s");
  pace_label_ = new QLabel;
  pace_label_->setObjectName("pace");
  seed_label_ = new QLabel;
  seed_label_->setObjectName("seed_shown");
  outcome_label_ = new QLabel;
  outcome_label_->setObjectName("outcome");
  recording_label_ = new QLabel;
  recording_label_->setObjectName("recording");
  for (QLabel* each : {recording_label_, time_label_, pace_label_, seed_label_, outcome_label_}) {
    statusBar()->addPermanentWidget(each);
  }
}

}  // namespace elsie::desktop
