#include "main_window.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCloseEvent>
#include <QDesktopServices>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QProcess>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolBar>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWindow>
#include <cmath>

#include "elsie/api/geometry.h"

#include "control_bar.h"
#include "film.h"
#include "scene/scene_view.h"
#include "start_page.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"
#include "world/behaviors_dialog.h"
#include "world/element_dialog.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/world_tree.h"

namespace elsie::desktop {
namespace {

constexpr int kMostRecent = 10;
constexpr int kSaid_ms = 8000;
constexpr qint64 kStuck_ms = 3000;
constexpr double kFilmRate = 25.0;  // pictures a second
constexpr auto kMime = "application/x-elsie-element";

/// The folder with the shipped worlds, of an installed program and of a build.
QString shipped_worlds() {
  const QDir folder(QApplication::applicationDirPath() + "/../share/elsie/worlds");
  return folder.exists() ? folder.canonicalPath() : QString();
}

/// To the millimetre and the hundredth of a degree: what a hand can do.
QString number(double value, double step = 0.001) {
  const double rounded = std::round(value / step) * step;
  return QString::number(rounded == 0.0 ? 0.0 : rounded, 'g', 9);
}

double attribute_number(const Json& element, const char* name) {
  return attribute(element, name).toDouble();
}

}  // namespace

MainWindow::MainWindow(const QString& elsie, const QStringList& options, QWidget* parent)
    : QMainWindow(parent), elsie_(elsie), options_(options), workbench_(elsie, options) {
  setObjectName("main_window");
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks | GroupedDragging);
  setAcceptDrops(true);
  ask_about_unsaved = [this](const QString& question) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), question,
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Save      ? Answer::save
           : answer == QMessageBox::Discard ? Answer::discard
                                            : Answer::cancel;
  };

  centre_ = new QStackedWidget;
  start_ = new StartPage(shipped_worlds());
  auto* view = new QWidget;
  auto* column = new QVBoxLayout(view);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  scene_ = new SceneView;
  time_line_ = new TimeLine(workbench_);
  column->addWidget(scene_, 1);
  column->addWidget(time_line_);
  centre_->addWidget(start_);
  centre_->addWidget(view);
  setCentralWidget(centre_);

  make_actions();
  make_docks();
  make_menus();
  connect_workbench();
  connect_views();

  resize(1280, 800);
  arrange("author");
  default_state_ = saveState();
  QSettings settings;
  if (!restoreGeometry(settings.value("geometry").toByteArray())) {
    resize(1280, 800);
  }
  restoreState(settings.value("layout").toByteArray());
  show_recent();
  show_state();
  show_title();
}

// The views go before what they show.
MainWindow::~MainWindow() {
  for (QDockWidget* each : std::as_const(docks_)) {
    each->disconnect(this);
  }
  workbench_.disconnect(this);
  qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));
  qDeleteAll(findChildren<QToolBar*>(Qt::FindDirectChildrenOnly));
  qDeleteAll(docks_);
  delete takeCentralWidget();
}

// Actions, menus, docks

QAction* MainWindow::action(const char* name, const QString& text, const QKeySequence& key,
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
  action("new", tr("&New world..."), QKeySequence::New, [this] { new_world(); });
  action("open", tr("&Open..."), QKeySequence::Open, [this] {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a world or a recording"), QFileInfo(workbench_.file()).path(),
        tr("Worlds and recordings (*.xml *.mcap);;All files (*)"));
    if (!file.isEmpty()) open(file);
  });
  action("save", tr("&Save"), QKeySequence::Save, [this] { save(false); });
  action("save_as", tr("Save &as..."), key("Ctrl+Shift+S"), [this] { save(true); });
  action("start_page", tr("Start &page"), {}, [this] { show_start(); });
  action("export_picture", tr("Export &picture..."), {}, [this] { export_picture(); });
  action(
      "export_film", tr("Export &film..."), {}, [this] { export_film(); },
      tr("Plays the run that was just made from its start into a film"));
  action(
      "record", tr("&Record the next run..."), {}, [this] { record(); },
      tr("Into CSV or MCAP files, from its start"));
  action("copy_command", tr("&Copy the command line that repeats this"), {},
         [this] { copy_command(); });
  action("quit", tr("&Quit"), QKeySequence::Quit, [this] { close(); });

  action("undo", tr("&Undo"), QKeySequence::Undo, [this] { workbench_.undo(); });
  action("redo", tr("&Redo"), key("Ctrl+Shift+Z"), [this] { workbench_.redo(); });
  action("cut", tr("Cu&t"), QKeySequence::Cut, [this] {
    copy_selected();
    remove_selected();
  });
  action("copy", tr("&Copy"), QKeySequence::Copy, [this] { copy_selected(); });
  action("paste", tr("&Paste"), QKeySequence::Paste, [this] {
    const QMimeData* held = QApplication::clipboard()->mimeData();
    paste(held->hasFormat(kMime) ? QString::fromUtf8(held->data(kMime)) : held->text());
  });
  action("duplicate", tr("&Duplicate"), key("Ctrl+D"), [this] { duplicate_selected(); });
  action("delete", tr("De&lete"), QKeySequence::Delete, [this] { remove_selected(); });
  action("rename", tr("Re&name..."), key("F2"), [this] { rename_selected(); });
  action("edit", tr("&Edit..."), key("Return"), [this] {
    if (!selection_.isEmpty()) edit_element(selection_.front());
  });
  // In trees and the view; a text keeps its keys.
  for (const char* name : {"edit", "delete", "cut", "copy", "paste", "duplicate"}) {
    actions_[name]->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    removeAction(actions_[name]);
    scene_->addAction(actions_[name]);
  }
  action("lock", tr("Loc&k against the mouse"), key("Ctrl+L"), [this] {
    for (const QString& path : selection_) {
      if (!locked_.remove(path)) locked_.insert(path);
    }
    scene_->set_locked(locked_);
    scene_->update();
  });
  action(
      "start_pose", tr("Make &start pose"), {}, [this] { make_start_poses(); },
      tr("The world begins with the chosen robots where they are now"));
  action("add_robot", tr("&Robot..."), {}, [this] { add_element({}, "robots"); });
  action("add_static", tr("&Standing box..."), {},
         [this] { add_element({}, "obstacles", "static_box"); });
  action("add_dynamic", tr("&Dynamic box..."), {},
         [this] { add_element({}, "obstacles", "dynamic_box"); });
  action("add_moving", tr("&Moving box..."), {},
         [this] { add_element({}, "obstacles", "moving_box"); });
  action("add_resource", tr("R&esource..."), {}, [this] { add_element({}, "resources"); });
  action("add_charger", tr("&Charger..."), {}, [this] { add_element({}, "chargers"); });
  action("add_goal", tr("&Goal..."), {}, [this] { add_element({}, "goals"); });
  action("add_measure", tr("Mea&sure..."), {}, [this] { add_element({}, "measures"); });
  action("add_team", tr("&Team..."), {}, [this] { add_element({}, "teams"); });

  action("run", tr("&Run or pause"), key("F5"), [this] {
    workbench_.run_state() == Workbench::Run::running ? workbench_.pause() : workbench_.run();
  });
  action("step", tr("&Step"), key("F10"), [this] { workbench_.step(); });
  action("reset", tr("R&eset"), key("Ctrl+R"), [this] { workbench_.reset(workbench_.seed()); });
  action(
      "physics", tr("&Physics parameters..."), {}, [this] { edit_element("physics"); },
      tr("Gravity, ERP, CFM or kp and kd, step: also while it runs"));
  action("arena", tr("&Arena..."), {}, [this] { edit_element("arena"); });
  action("limits", tr("&Limits..."), {}, [this] { edit_element("limits"); });
  action(
      "stop_engine", tr("Stop the engine &now"), {}, [this] { workbench_.engine().kill(); },
      tr("For a plugin that does not come back: the engine begins anew, the world stays"));

  action("view_all", tr("Show &all"), key("Home"), [this] { scene_->show_all(); });
  action("view_top", tr("From the &top"), {}, [this] { scene_->look_from_top(); });
  action("view_front", tr("From the &front"), {}, [this] { scene_->look_from_front(); });
  action("view_side", tr("From the &side"), {}, [this] { scene_->look_from_side(); });
  action("follow", tr("F&ollow the chosen robot"), {}, [this] {
    scene_->follow(scene_->followed().isEmpty() && !selection_.isEmpty() ? selection_.front()
                                                                         : QString());
  });
  action("measure", tr("&Measuring tape"), {}, [this] {
    scene_->set_tool(scene_->tool() == SceneView::Tool::measure ? SceneView::Tool::move
                                                                : SceneView::Tool::measure);
  });
  const auto overlay = [&](const char* name, const QString& text,
                           bool SceneView::Overlays::*which) {
    QAction* made = action(name, text, {}, [this, which, name] {
      scene_->overlays().*which = actions_[name]->isChecked();
      scene_->update();
    });
    made->setCheckable(true);
    made->setChecked(scene_->overlays().*which);
  };
  overlay("show_trails", tr("&Trajectories"), &SceneView::Overlays::trails);
  overlay("show_beams", tr("&Beams"), &SceneView::Overlays::beams);
  overlay("show_views", tr("Fields of &view"), &SceneView::Overlays::views);
  overlay("show_names", tr("&Names"), &SceneView::Overlays::names);
  overlay("show_grid", tr("&Grid"), &SceneView::Overlays::grid);
  action("clear_trails", tr("&Clear trajectories"), {}, [this] { scene_->clear_trails(); });
  for (const auto& [layout, text] : {std::pair{"author", tr("Layout: &author")},
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
    bool is_chosen = false;
    const QString name =
        QInputDialog::getItem(this, tr("Commands"), tr("Command"), names, 0, true, &is_chosen);
    if (is_chosen && by_name.contains(name)) by_name[name]->trigger();
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
    text += rows.join("") + "</table>" +
            tr("<p>In the view: the left button orbits, the right one pans, the wheel zooms; a "
               "click chooses, with Shift several; a right click edits. "
               "Ctrl and a button always move the camera. Handles move, turn and resize; Ctrl "
               "snaps, Shift refines. "
               "7, 1, 3: from the top, the front, the side. F frames, Shift+F follows, M measures, "
               "arrows move what is chosen.</p>");
    QMessageBox box(QMessageBox::NoIcon, tr("Keys"), text, QMessageBox::Close, this);
    box.exec();
  });
  action("about", tr("&About"), {}, [this] { about(); });
}

void MainWindow::make_menus() {
  const auto fill = [this](QMenu* menu, const QStringList& names) {
    for (const QString& name : names) {
      name.isEmpty() ? static_cast<void>(menu->addSeparator()) : menu->addAction(actions_[name]);
    }
  };
  QMenu* file = menuBar()->addMenu(tr("&File"));
  fill(file, {"new", "open"});
  recent_ = file->addMenu(tr("Opened &last"));
  fill(file, {"start_page", "", "save", "save_as", "", "export_picture", "export_film", "record",
              "copy_command", "", "quit"});
  QMenu* edit = menuBar()->addMenu(tr("&Edit"));
  fill(edit, {"undo", "redo", "", "cut", "copy", "paste", "duplicate", "delete", "", "edit",
              "rename", "start_pose", "lock", ""});
  QMenu* add = edit->addMenu(tr("&Add"));
  add->setObjectName("add_menu");
  fill(add, {"add_robot", "add_static", "add_dynamic", "add_moving", "add_resource", "add_charger",
             "", "add_goal", "add_measure", "add_team"});
  QMenu* view = menuBar()->addMenu(tr("&View"));
  fill(view,
       {"view_all", "view_top", "view_front", "view_side", "follow", "measure", "", "show_trails",
        "show_beams", "show_views", "show_names", "show_grid", "clear_trails", ""});
  windows_ = view->addMenu(tr("&Windows"));
  connect(windows_, &QMenu::aboutToShow, this, [this] {
    windows_->clear();
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
      windows_->addAction(each->toggleViewAction());
    }
  });
  fill(view, {"layout_author", "layout_watch", "layout_train", "layout_reset", "next_dock"});
  QMenu* simulation = menuBar()->addMenu(tr("&Simulation"));
  fill(simulation, {"run", "step", "reset", "", "physics", "arena", "limits", "", "stop_engine"});
  QMenu* help = menuBar()->addMenu(tr("&Help"));
  fill(help, {"commands", "keys", "about"});

  QToolBar* bar = addToolBar(tr("Tools"));
  bar->setObjectName("tools");
  for (const char* name : {"new", "open", "save"}) bar->addAction(actions_[name]);
  bar->addSeparator();
  for (const char* name : {"undo", "redo"}) bar->addAction(actions_[name]);
  bar->addSeparator();
  control_bar_ = new ControlBar(workbench_);
  bar->addWidget(control_bar_);
  QToolBar* environment = addToolBar(tr("Environment"));
  environment->setObjectName("environment");
  for (const char* name : {"add_robot", "add_static", "add_dynamic", "add_moving", "add_resource",
                           "add_charger", "measure"}) {
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
  for (QLabel* each : {time_label_, pace_label_, seed_label_, outcome_label_}) {
    statusBar()->addPermanentWidget(each);
  }
}

QDockWidget* MainWindow::dock(const char* name, const QString& title, QWidget* widget,
                              Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(title, this);
  made->setObjectName(QString("dock_") + name);
  made->setWidget(widget);
  addDockWidget(area, made);
  docks_[name] = made;
  return made;
}

void MainWindow::make_docks() {
  world_tree_ = new WorldTree(workbench_);
  dock("world", tr("World"), world_tree_, Qt::LeftDockWidgetArea);
  properties_ = new Properties(workbench_);
  dock("properties", tr("Properties"), properties_, Qt::RightDockWidgetArea);
  const auto make_tree = [this](WorldTree* tree) {
    connect(tree, &WorldTree::selected, this, &MainWindow::select);
    connect(tree, &WorldTree::edit_wished, this, &MainWindow::edit_element);
    connect(tree, &WorldTree::add_wished, this,
            [this](const QString& holder, const QString& list) { add_element(holder, list); });
    connect(tree, &WorldTree::behaviors_wished, this, &MainWindow::edit_behaviors);
    connect(tree, &WorldTree::menu_wished, this, &MainWindow::element_menu);
    for (const char* name : {"delete", "cut", "copy", "paste", "duplicate"}) {
      tree->addAction(actions_[name]);
    }
  };
  make_tree(world_tree_);
  for (const QString& team : {QString("red"), QString("blue")}) {
    teams_[team] = new WorldTree(workbench_, team);
    make_tree(teams_[team]);
    dock(("team_" + team).toUtf8().constData(), tr("Team %1").arg(team), teams_[team],
         Qt::LeftDockWidgetArea);
  }
  coordination_ = new CoordinationPanel;
  plots_ = new PlotsPanel;
  editor_ = new WorldEditor;
  problems_ = new ProblemsPanel;
  vision_ = new VisionPanel;
  fuzzy_ = new FuzzyPanel;
  sensors_ = new SensorsPanel;
  dock("coordination", tr("Coordination"), coordination_, Qt::BottomDockWidgetArea);
  dock("plots", tr("Plots"), plots_, Qt::BottomDockWidgetArea);
  dock("text", tr("Text"), editor_, Qt::BottomDockWidgetArea);
  dock("problems", tr("Errors"), problems_, Qt::BottomDockWidgetArea);
  dock("vision", tr("Vision"), vision_, Qt::RightDockWidgetArea);
  dock("fuzzy", tr("Fuzzy"), fuzzy_, Qt::RightDockWidgetArea);
  dock("sensors", tr("Sensors"), sensors_, Qt::RightDockWidgetArea);
  for (const char* name : {"coordination", "plots", "vision", "fuzzy", "sensors"}) {
    connect(docks_[name], &QDockWidget::visibilityChanged, this, &MainWindow::watch);
  }
}

void MainWindow::arrange(const QString& layout) {
  for (QDockWidget* each : std::as_const(docks_)) {
    each->setFloating(false);
    each->hide();
  }
  const auto put = [this](Qt::DockWidgetArea area, const QStringList& names) {
    QDockWidget* first = nullptr;
    for (const QString& name : names) {
      QDockWidget* each = docks_.value(name);
      if (!each) continue;
      addDockWidget(area, each);
      each->show();
      if (first) {
        tabifyDockWidget(first, each);
      }
      first = first ? first : each;
    }
    if (first) first->raise();
  };
  QStringList trees{"world"};
  for (const QString& name : docks_.keys()) {
    if (name.startsWith("team_")) trees << name;
  }
  put(Qt::LeftDockWidgetArea, trees);
  if (layout == "watch") {
    put(Qt::RightDockWidgetArea, {"vision", "fuzzy", "sensors"});
    put(Qt::BottomDockWidgetArea, {"coordination", "plots"});
  } else if (layout == "train") {
    put(Qt::RightDockWidgetArea, {"properties"});
    put(Qt::BottomDockWidgetArea, {"coordination", "plots", "text"});
  } else {
    put(Qt::RightDockWidgetArea, {"properties"});
    put(Qt::BottomDockWidgetArea, {"coordination", "plots", "text", "problems"});
  }
  QList<QDockWidget*> columns{docks_.value("world")};
  QList<int> widths{220};
  QDockWidget* right = docks_.value(layout == "watch" ? "vision" : "properties");
  if (right) {
    columns << right;
    widths << 280;
  }
  resizeDocks(columns, widths, Qt::Horizontal);
  if (QDockWidget* bottom = docks_.value("coordination")) {
    resizeDocks({bottom}, {170}, Qt::Vertical);
  }
}

// Connections

void MainWindow::connect_workbench() {
  connect(&workbench_, &Workbench::described, this, [this] {
    scene_->set_scene(workbench_.scene(), workbench_.epoch());
    world_tree_->show_world();
    show_teams();
    for (WorldTree* each : std::as_const(teams_)) each->show_world();
    QStringList still;
    for (const QString& path : std::as_const(selection_)) {
      if (place_of(workbench_.tree(), path).element || !path.contains('[')) still << path;
    }
    if (still != selection_) select(still);
    editor_->set_text(workbench_.text());
    if (watched_robot_.isEmpty() ||
        !place_of(workbench_.tree(), "robot[" + watched_robot_ + ']').element) {
      for (const Stage::Body& body : scene_->stage().bodies()) {
        if (body.path.startsWith("robot[")) {
          watch_robot(body.path.mid(6, body.path.size() - 7));
          break;
        }
      }
    }
    watch();
    show_title();
  });
  connect(&workbench_, &Workbench::problems_changed, this, [this] {
    problems_->set_problems(workbench_.problems());
    editor_->set_problems(workbench_.problems());
    if (!workbench_.problems().empty() && !editor_->hasFocus()) {
      docks_["problems"]->show();
      docks_["problems"]->raise();
    }
    editor_->set_text(workbench_.text());
  });
  connect(&workbench_, &Workbench::state, this, [this](const Json& state) {
    if (docks_["coordination"]->isVisible()) coordination_->add(state);
    if (docks_["plots"]->isVisible()) plots_->add(state);
    if (docks_["vision"]->isVisible()) vision_->add(state);
    if (docks_["fuzzy"]->isVisible()) fuzzy_->add(state);
    if (docks_["sensors"]->isVisible()) sensors_->add(state);
  });
  connect(&workbench_, &Workbench::snapshot, this, [this](const snapshots::Snapshot& snapshot) {
    scene_->take(snapshot);
    show_state();
  });
  connect(&workbench_, &Workbench::history_changed, this, [this] {
    const QString undo = workbench_.undo_name(), redo = workbench_.redo_name();
    actions_["undo"]->setText(undo.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undo));
    actions_["undo"]->setEnabled(!undo.isEmpty());
    actions_["redo"]->setText(redo.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redo));
    actions_["redo"]->setEnabled(!redo.isEmpty());
    show_title();
  });
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    if (workbench_.run_state() == Workbench::Run::ready) {
      outcome_.clear();
      scene_->clear_trails();
      time_line_->clear();
      coordination_->clear();
      plots_->clear();
    }
    show_state();
  });
  connect(&workbench_, &Workbench::ended, this, [this](const Json& end) {
    const QString reason = QString::fromStdString(end.value("reason", std::string()));
    outcome_ = QString::fromStdString(end.value("outcome", std::string()));
    outcome_label_->setToolTip(
        tr("%1\nstate hash %2")
            .arg(reason, QString::fromStdString(end.value("state_hash", std::string()))));
    say(reason.isEmpty() ? tr("The run has ended: %1").arg(outcome_)
                         : tr("The run has ended: %1, %2").arg(outcome_, reason));
    show_state();
  });
  connect(&workbench_, &Workbench::raised, this, [this](const Json& event) {
    time_line_->mark(event.value("time_s", 0.0),
                     QString::fromStdString(event.value("name", std::string())));
  });
  connect(&workbench_, &Workbench::noted, this, &MainWindow::say);
  connect(&workbench_, &Workbench::refused, this, [this](const Problems& problems) {
    if (!problems.empty()) say(problems.front().message);
  });
  connect(&workbench_, &Workbench::engine_lost, this, [this](const QString& report) {
    auto* box = new QMessageBox(QMessageBox::Warning, tr("The engine was started again"),
                                tr("A plugin ended the engine. Your world and its unsaved changes "
                                   "are here; the run begins anew."),
                                QMessageBox::Ok, this);
    box->setObjectName("engine_lost");
    box->setInformativeText(report.section('\n', 0, 0));
    box->setDetailedText(report);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
  connect(&workbench_, &Workbench::changed_on_disk, this, [this] {
    QMessageBox box(
        QMessageBox::Question, tr("The file has changed"),
        tr("Another program has changed '%1'. Read it again? What is unsaved here would be lost.")
            .arg(workbench_.file()),
        QMessageBox::Yes | QMessageBox::No, this);
    box.setObjectName("changed_on_disk");
    if (box.exec() == QMessageBox::Yes) {
      QString why;
      if (!workbench_.open(workbench_.file(), why)) say(why);
    }
  });
  connect(&workbench_, &Workbench::catalog_changed, this, [this] {
    world_tree_->show_world();
    editor_->set_catalog(workbench_.catalog().json());
    say(tr("%1 plugins are there")
            .arg(workbench_.catalog().json().value("plugins", Json::array()).size()));
  });
  auto* watch_dog = new QTimer(this);
  connect(watch_dog, &QTimer::timeout, this, [this] {
    if (workbench_.engine().waiting_ms() > kStuck_ms) {
      statusBar()->showMessage(
          tr("The engine does not answer: a plugin takes long. Simulation, 'Stop the engine now' "
             "begins it anew."));
    }
  });
  watch_dog->start(1000);
}

void MainWindow::connect_views() {
  connect(scene_, &SceneView::selected, this, &MainWindow::select);
  connect(scene_, &SceneView::edit_wished, this,
          [this](const QString& path) { edit_element(path); });
  connect(scene_, &SceneView::menu_wished, this, &MainWindow::floor_menu);
  connect(scene_, &SceneView::moved, this, &MainWindow::moved);
  connect(scene_, &SceneView::turned, this, &MainWindow::turned);
  connect(scene_, &SceneView::resized, this, &MainWindow::resized);
  connect(scene_, &SceneView::measured, this, [this](double x, double y, double to_x, double to_y) {
    say(tr("from (%1, %2) to (%3, %4): %5 m")
            .arg(number(x), number(y), number(to_x), number(to_y),
                 number(std::hypot(to_x - x, to_y - y))));
  });
  connect(editor_, &WorldEditor::edited, &workbench_, &Workbench::type);
  connect(editor_, &WorldEditor::undo_wished, &workbench_, &Workbench::undo);
  connect(editor_, &WorldEditor::redo_wished, &workbench_, &Workbench::redo);
  connect(problems_, &ProblemsPanel::go_to, this, &MainWindow::go_to);
  connect(start_, &StartPage::open_wished, this, [this](const QString& file) { open(file); });
  connect(start_, &StartPage::new_wished, this, &MainWindow::new_world);
  connect(start_, &StartPage::browse_wished, this, [this] { actions_["open"]->trigger(); });
}

// What the engine sends

void MainWindow::watch() {
  Json what = Json::array();
  const auto shows = [this](const char* name) { return docks_[name]->isVisible(); };
  if (shows("coordination") || shows("plots")) what.push_back("decisions");
  if (shows("sensors") || shows("plots")) what.push_back("sensors");
  if (shows("plots")) what.push_back("measures");
  if (shows("vision")) what.push_back("cameras");
  if (shows("fuzzy")) what.push_back("fuzzy");
  const Json order{{"do", "watch"}, {"what", what}, {"robots", Json::array()}};
  const QString asked =
      QString::fromStdString(order.dump()) + QString::number(workbench_.engine().generation());
  if (asked != watched_ && workbench_.tree().is_object()) {
    watched_ = asked;
    workbench_.ask(order, {});
  }
}

void MainWindow::watch_robot(const QString& id) {
  if (id != watched_robot_) {
    watched_robot_ = id;
    coordination_->set_robot(id);
    fuzzy_->set_robot(id);
    sensors_->set_robot(id);
  }
}

void MainWindow::go_to(const QString& file, int line) {
  if (!file.isEmpty() && !workbench_.file().isEmpty() &&
      QFileInfo(file).fileName() != QFileInfo(workbench_.file()).fileName()) {
    say(tr("That is in another file: %1, line %2").arg(file).arg(line));
    return;
  }
  docks_["text"]->show();
  docks_["text"]->raise();
  editor_->go_to(line);
}

// Files

bool MainWindow::may_leave() {
  if (!workbench_.is_modified()) {
    return true;
  }
  const QString name = workbench_.file().isEmpty()
                           ? tr("The new world")
                           : '\'' + QFileInfo(workbench_.file()).fileName() + '\'';
  switch (ask_about_unsaved(tr("%1 has changes that are not saved. Save them?").arg(name))) {
    case Answer::save:
      return save(false);
    case Answer::discard:
      return true;
    default:
      return false;
  }
}

bool MainWindow::open(const QString& file) {
  if (!may_leave()) {
    return false;
  }
  QString world = file, why;
  if (file.endsWith(".mcap")) {
    // The world of a recording, as it was at its start, with the edits that were made.
    QTemporaryDir folder;
    folder.setAutoRemove(false);
    world = folder.filePath(QFileInfo(file).completeBaseName() + ".xml");
    QProcess replay;
    replay.start(elsie_, QStringList{"replay", file, "--world", world} + options_);
    if (!replay.waitForFinished(60'000) || !QFileInfo::exists(world)) {
      QMessageBox::warning(this, tr("The recording cannot be opened"),
                           QString::fromUtf8(replay.readAllStandardError()).trimmed());
      return false;
    }
  }
  if (!workbench_.open(world, why)) {
    QMessageBox::warning(this, tr("The world cannot be opened"), why);
    return false;
  }
  note_recent(file);
  outcome_.clear();
  locked_.clear();
  select({});
  centre_->setCurrentIndex(1);
  scene_->setFocus();
  show_title();
  return true;
}

void MainWindow::new_world() {
  if (!may_leave()) {
    return;
  }
  const QString text = ask_for_new_world(this);
  if (!text.isEmpty()) {
    workbench_.open_text(text, {}, false);
    centre_->setCurrentIndex(1);
    show_title();
  }
}

bool MainWindow::save(bool elsewhere) {
  QString file = workbench_.file();
  if (elsewhere || file.isEmpty()) {
    QFileDialog dialog(this, tr("Save the world"),
                       file.isEmpty() ? QDir::currentPath() + "/world.xml" : file,
                       tr("Worlds (*.xml)"));
    dialog.setObjectName("save_dialog");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix("xml");
    if (dialog.exec() != QDialog::Accepted) {
      return false;
    }
    file = dialog.selectedFiles().front();
  } else if (workbench_.is_changed_on_disk()) {
    const auto answer = QMessageBox::question(
        this, tr("The file has changed"),
        tr("Another program has changed '%1' since it was opened. Write over it?").arg(file));
    if (answer != QMessageBox::Yes) {
      return false;
    }
  }
  QEventLoop waiting;
  bool is_saved = false;
  workbench_.save_as(file, [&](const QString& why) {
    is_saved = why.isEmpty();
    if (!is_saved) QMessageBox::warning(this, tr("Not saved"), why);
    waiting.quit();
  });
  const auto lost = connect(&workbench_, &Workbench::engine_lost, &waiting, &QEventLoop::quit);
  if (!is_saved && workbench_.engine().waiting_ms() >= 0 && workbench_.is_right()) {
    waiting.exec(QEventLoop::ExcludeUserInputEvents);
  }
  disconnect(lost);
  if (is_saved) {
    note_recent(workbench_.file());
    say(tr("Saved as '%1'").arg(workbench_.file()));
  }
  show_title();
  return is_saved;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!may_leave()) {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", saveState());
  event->accept();
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (was_shown_) {
    return;
  }
  was_shown_ = true;
  // A window that was left on a screen that is not there any more comes back.
  for (QDockWidget* each : findChildren<QDockWidget*>()) {
    if (each->isFloating() && !screen()->virtualGeometry().intersects(each->geometry())) {
      each->move(pos() + QPoint(40, 40));
    }
  }
}

void MainWindow::offer_recovered() {
  for (const Recovered& each : Recovery::left_behind()) {
    QMessageBox box(QMessageBox::Question, tr("Unsaved work"),
                    tr("A window was not closed properly. Take up its unsaved work on %1?")
                        .arg(each.file.isEmpty() ? tr("a new world") : '\'' + each.file + '\''),
                    QMessageBox::Yes | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setObjectName("recovered");
    const int answer = box.exec();
    if (answer == QMessageBox::Yes) {
      workbench_.open_text(each.text, each.file, false);
      Recovery::discard(each);
      centre_->setCurrentIndex(1);
      return;
    }
    if (answer == QMessageBox::Discard) {
      Recovery::discard(each);
    }
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (!event->mimeData()->urls().isEmpty()) open(event->mimeData()->urls().front().toLocalFile());
}

void MainWindow::note_recent(const QString& file) {
  QSettings settings;
  QStringList files = settings.value("recent").toStringList();
  const QString absolute = QFileInfo(file).absoluteFilePath();
  files.removeAll(absolute);
  files.prepend(absolute);
  settings.setValue("recent", files.mid(0, kMostRecent));
  show_recent();
}

void MainWindow::show_recent() {
  const QStringList files = QSettings().value("recent").toStringList();
  start_->show_recent(files);
  recent_->clear();
  for (const QString& file : files) {
    connect(recent_->addAction(file), &QAction::triggered, this, [this, file] { open(file); });
  }
  recent_->setEnabled(!files.isEmpty());
}

void MainWindow::show_start() {
  centre_->setCurrentIndex(centre_->currentIndex() == 0 && workbench_.tree().is_object() ? 1 : 0);
}

// What is shown

void MainWindow::show_title() {
  const QString name =
      workbench_.file().isEmpty() ? tr("new world") : QFileInfo(workbench_.file()).fileName();
  setWindowTitle((workbench_.text().isEmpty() ? QString() : name + "[*] - ") + "Elsie");
  setWindowModified(workbench_.is_modified() && !workbench_.text().isEmpty());
}

void MainWindow::show_state() {
  time_label_->setText(tr("%1 s").arg(workbench_.time_s(), 0, 'f', 2));
  const QString wanted =
      workbench_.speed() > 0.0 ? QString::number(workbench_.speed()) + 'x' : tr("maximum");
  pace_label_->setText(workbench_.run_state() == Workbench::Run::running
                           ? tr("%1x of %2").arg(workbench_.pace(), 0, 'f', 1).arg(wanted)
                           : wanted);
  seed_label_->setText(tr("seed %1").arg(workbench_.seed()));
  const QHash<Workbench::Run, QString> words{{Workbench::Run::none, tr("no world")},
                                             {Workbench::Run::ready, tr("ready")},
                                             {Workbench::Run::running, tr("running")},
                                             {Workbench::Run::paused, tr("paused")},
                                             {Workbench::Run::ended, tr("ended")}};
  const QString word = words.value(workbench_.run_state());
  outcome_label_->setText(outcome_.isEmpty() ? word : word + ": " + outcome_);
}

void MainWindow::show_teams() {
  for (const QString& team : teams_of(workbench_.tree())) {
    if (teams_.contains(team)) {
      continue;
    }
    auto* tree = new WorldTree(workbench_, team);
    teams_[team] = tree;
    connect(tree, &WorldTree::selected, this, &MainWindow::select);
    connect(tree, &WorldTree::edit_wished, this, &MainWindow::edit_element);
    connect(tree, &WorldTree::add_wished, this,
            [this](const QString& holder, const QString& list) { add_element(holder, list); });
    connect(tree, &WorldTree::behaviors_wished, this, &MainWindow::edit_behaviors);
    connect(tree, &WorldTree::menu_wished, this, &MainWindow::element_menu);
    QDockWidget* made = dock(("team_" + team).toUtf8().constData(), tr("Team %1").arg(team), tree,
                             Qt::LeftDockWidgetArea);
    tabifyDockWidget(docks_["world"], made);
    docks_["world"]->raise();
  }
}

void MainWindow::say(const QString& text) { statusBar()->showMessage(text, kSaid_ms); }

void MainWindow::select(const QStringList& paths) {
  selection_ = paths;
  scene_->set_selection(paths);
  world_tree_->set_selection(paths);
  for (WorldTree* each : std::as_const(teams_)) each->set_selection(paths);
  properties_->show_element(paths.isEmpty() ? QString() : paths.front());
  if (!paths.isEmpty() && paths.front().startsWith("robot[")) {
    watch_robot(paths.front().section(']', 0, 0).mid(6));
  }
}

// Changes

void MainWindow::edit_element(const QString& path) {
  QString why;
  if (ElementDialog* dialog = ElementDialog::edit(workbench_, path, this, why)) {
    dialog->show();
  } else {
    say(why);
  }
}

void MainWindow::add_element(const QString& holder, const QString& list, const QString& kind,
                             std::optional<QPointF> at) {
  if (!workbench_.tree().is_object()) {
    say(tr("There is no world to add to: open one, or make a new one."));
    return;
  }
  if (holder.isEmpty() && (list == "sensors" || list == "behaviors" || list == "coordinator")) {
    say(tr("Choose the robot first."));
    return;
  }
  ElementDialog* dialog = ElementDialog::make(workbench_, holder, list, this);
  if (!kind.isEmpty()) dialog->choose(kind);
  if (list == "robots") {
    for (auto team = teams_.begin(); team != teams_.end(); ++team) {
      if (sender() == team.value()) dialog->begin_with("team", team.key());
    }
  }
  if (at) {
    dialog->begin_with("x", number(at->x(), 0.01));
    dialog->begin_with("y", number(at->y(), 0.01));
  }
  dialog->show();
}

void MainWindow::edit_behaviors(const QString& holder) {
  if (holder.isEmpty()) {
    say(tr("Choose the robot first."));
    return;
  }
  (new BehaviorsDialog(workbench_, holder, this))->show();
}

void MainWindow::element_menu(const QString& path, const QPoint& global) {
  if (path.isEmpty()) {
    floor_menu(global, 0.0, 0.0);
    return;
  }
  QMenu menu(this);
  menu.setObjectName("element_menu");
  menu.addAction(tr("&Edit..."), this, [this, path] { edit_element(path); });
  const ElementPlace place = place_of(workbench_.tree(), path);
  const auto kind = workbench_.catalog().kind_of(place);
  const bool is_robot = kind && kind->name == "robot";
  if (is_robot) {
    menu.addAction(tr("Add &sensor..."), this, [this, path] { add_element(path, "sensors"); });
    menu.addAction(tr("&Behaviours..."), this, [this, path] { edit_behaviors(path); });
    menu.addAction(tr("&Coordinator..."), this, [this, path] { add_element(path, "coordinator"); });
    menu.addAction(tr("&Follow"), this, [this, path] { scene_->follow(path); });
  }
  if (kind && kind->holds_behaviors) {
    menu.addAction(tr("&Behaviours in it..."), this, [this, path] { edit_behaviors(path); });
    menu.addAction(tr("&Coordinator in it..."), this,
                   [this, path] { add_element(path, "coordinator"); });
  }
  if (path.endsWith("/coordinator")) {
    menu.addAction(tr("&Replace..."), this,
                   [this, path] { add_element(holder_of(path), "coordinator"); });
    if (place.element && !attribute(*place.element, "weights").isEmpty()) {
      // As the original's right click on a trained network.
      menu.addAction(tr("C&lear the network"), this, [this, path] {
        workbench_.edit({path + "/@weights/@remove=true"}, tr("clear the network"));
      });
    }
  }
  menu.addSeparator();
  menu.addAction(tr("&Duplicate"), this, [this] { duplicate_selected(); });
  menu.addAction(tr("De&lete"), this, [this] { remove_selected(); });
  if (!selection_.contains(path)) select({path});
  menu.exec(global);
}

void MainWindow::floor_menu(const QPoint& global, double x, double y) {
  QMenu menu(this);
  menu.setObjectName("floor_menu");
  const QPointF at(x, y);
  menu.addAction(tr("Add &robot here..."), this, [this, at] { add_element({}, "robots", {}, at); });
  menu.addAction(tr("Add &standing box here..."), this,
                 [this, at] { add_element({}, "obstacles", "static_box", at); });
  menu.addAction(tr("Add &dynamic box here..."), this,
                 [this, at] { add_element({}, "obstacles", "dynamic_box", at); });
  menu.addAction(tr("Add &moving box here..."), this,
                 [this, at] { add_element({}, "obstacles", "moving_box", at); });
  menu.addAction(tr("Add r&esource here..."), this,
                 [this, at] { add_element({}, "resources", {}, at); });
  menu.addAction(tr("Add &charger here..."), this,
                 [this, at] { add_element({}, "chargers", {}, at); });
  menu.exec(global);
}

void MainWindow::remove_selected() {
  QStringList edits;
  // From the back: an edit may change how those after it are called.
  for (auto path = selection_.rbegin(); path != selection_.rend(); ++path) {
    edits << *path + "/@remove=true";
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits, selection_.size() == 1 ? tr("delete %1").arg(selection_.front())
                                                  : tr("delete %n things", nullptr,
                                                       static_cast<int>(selection_.size())));
  }
}

void MainWindow::copy_selected() {
  QString text;
  for (const QString& path : std::as_const(selection_)) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    if (place.element) text += markup_of(*place.element) + '\n';
  }
  if (text.isEmpty()) {
    return;
  }
  auto* held = new QMimeData;
  held->setText(text);
  held->setData(kMime, text.toUtf8());
  QApplication::clipboard()->setMimeData(held);
}

void MainWindow::paste(const QString& text) {
  // Where an element may stand is said by its name.
  static const QHash<QString, QString> lists{{"robot", "robot"},
                                             {"static_box", "obstacle"},
                                             {"dynamic_box", "obstacle"},
                                             {"moving_box", "obstacle"},
                                             {"resource", "resource"},
                                             {"charger", "charger"},
                                             {"team", "team"}};
  const QString robot = world_tree_->robot();
  QStringList edits;
  for (const QString& line : text.split('\n', Qt::SkipEmptyParts)) {
    const QString name = line.trimmed().mid(1).section(QRegularExpression("[\\s/>]"), 0, 0);
    QString list = lists.value(name);
    for (const auto& [kind, word] : {std::pair{"sensor", "sensor"}, {"behavior", "behavior"}}) {
      for (const Kind& each : workbench_.catalog().plugins(kind)) {
        if (list.isEmpty() && each.name == name && !robot.isEmpty()) list = robot + '/' + word;
      }
    }
    if (list.isEmpty()) {
      list = "goal";
    }
    // Its id is in use, and its place is taken: it gets a new id, and stands aside.
    static const QRegularExpression id("^(<\\w+[^>]*?)\\sid=\"[^\"]*\"");
    static const QRegularExpression x("^(<\\w+[^>]*?\\sx=\")([^\"]*)\"");
    QString markup = line.trimmed();
    markup.replace(id, "\\1");
    const auto at = x.match(markup);
    if (at.hasMatch()) {
      markup.replace(at.capturedStart(2), at.capturedLength(2),
                     number(at.captured(2).toDouble() + 0.3));
    } else if (lists.contains(name) && name != "team") {
      markup.insert(1 + name.size(), " x=\"0.3\"");
    }
    edits << list + "[+]=" + markup;
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits, tr("paste"));
  }
}

void MainWindow::duplicate_selected() {
  QString text;
  for (const QString& path : std::as_const(selection_)) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    if (place.element) text += markup_of(*place.element) + '\n';
  }
  paste(text);
}

void MainWindow::rename_selected() {
  if (selection_.isEmpty()) {
    return;
  }
  const QString path = selection_.front();
  const ElementPlace place = place_of(workbench_.tree(), path);
  bool is_given = false;
  const QString name =
      QInputDialog::getText(this, tr("Rename"), tr("Name of %1").arg(path), QLineEdit::Normal,
                            place.element ? title_of(*place.element) : QString(), &is_given);
  if (is_given && !name.isEmpty()) {
    workbench_.edit({attribute_path(path, "id") + '=' + name}, tr("rename %1").arg(path));
  }
}

void MainWindow::moved(const QStringList& paths, double by_x, double by_y) {
  QStringList edits;
  for (const QString& path : paths) {
    const ElementPlace place = place_of(workbench_.tree(), path);
    if (!place.element) continue;
    const Stage::Body* body = scene_->stage().body_of(path);
    const double x = body ? body->frame.origin.x : attribute_number(*place.element, "x");
    const double y = body ? body->frame.origin.y : attribute_number(*place.element, "y");
    edits << path + "/@x=" + number(x + by_x) << path + "/@y=" + number(y + by_y);
  }
  if (!edits.isEmpty()) {
    workbench_.edit(edits,
                    paths.size() == 1
                        ? tr("move %1").arg(paths.front())
                        : tr("move %n things", nullptr, static_cast<int>(paths.size())),
                    "move " + paths.join(' '));
  }
}

void MainWindow::turned(const QString& path, double by_rad) {
  if (const Stage::Body* body = scene_->stage().body_of(path)) {
    const double heading = std::atan2(body->frame.forward.y, body->frame.forward.x) + by_rad;
    workbench_.edit({path + "/@heading_deg=" + number(degrees(wrap_angle(heading)), 0.01)},
                    tr("turn %1").arg(path), "turn " + path);
  }
}

void MainWindow::resized(const QString& path, double length, double width) {
  workbench_.edit({path + "/@length=" + number(length), path + "/@width=" + number(width)},
                  tr("resize %1").arg(path), "resize " + path);
}

void MainWindow::make_start_poses() {
  QStringList edits;
  for (const QString& path : std::as_const(selection_)) {
    const Stage::Body* body = scene_->stage().body_of(path);
    if (body && path.startsWith("robot[")) {
      edits << path + "/@x=" + number(body->frame.origin.x)
            << path + "/@y=" + number(body->frame.origin.y)
            << path + "/@heading_deg=" +
                   number(degrees(std::atan2(body->frame.forward.y, body->frame.forward.x)), 0.01);
    }
  }
  if (!edits.isEmpty()) workbench_.edit(edits, tr("make start pose"));
}

// Export

void MainWindow::export_picture() {
  const QString file = QFileDialog::getSaveFileName(this, tr("Export the picture"), "world.png",
                                                    tr("Pictures (*.png *.jpg)"));
  if (!file.isEmpty() && !scene_->picture().save(file)) {
    QMessageBox::warning(this, tr("Not exported"),
                         tr("The picture could not be written to '%1'.").arg(file));
  }
}

void MainWindow::export_film() {
  const double until_s = workbench_.time_s();
  if (until_s <= 0.0) {
    say(tr("There is no run to show: run the world first."));
    return;
  }
  const QString file =
      QFileDialog::getSaveFileName(this, tr("Export the film"), "run.avi", tr("Films (*.avi)"));
  if (file.isEmpty()) {
    return;
  }
  if (workbench_.run_state() == Workbench::Run::running) workbench_.pause();
  auto film = std::make_shared<Film>(file, kFilmRate);
  const auto next = std::make_shared<std::function<void(double)>>();
  *next = [this, film, until_s, next, file](double time_s) {
    if (time_s > until_s + 1e-9) {
      const bool is_whole = film->end();
      time_line_->go_to_now();
      is_whole ? say(tr("%1 pictures in '%2'").arg(film->frames()).arg(file))
               : static_cast<void>(QMessageBox::warning(this, tr("Not exported"), film->error()));
      *next = {};
      return;
    }
    workbench_.ask({{"do", "at"}, {"time_s", time_s}},
                   [this, film, next, time_s, until_s](const Json&) {
                     say(tr("Film: %1 of %2 s").arg(time_s, 0, 'f', 1).arg(until_s, 0, 'f', 1));
                     const auto keep = *next;
                     film->add(scene_->picture());
                     keep(time_s + 1.0 / kFilmRate);
                   });
  };
  (*next)(0.0);
}

void MainWindow::record() {
  const QStringList files =
      QFileDialog::getSaveFileName(this, tr("Record the next run"), "run.mcap",
                                   tr("Recordings (*.mcap *.csv)"))
          .split('\n', Qt::SkipEmptyParts);
  if (files.isEmpty()) {
    return;
  }
  workbench_.ask({{"do", "record"}, {"files", {files.front().toStdString()}}},
                 [this, files](const Json& answer) {
                   const Problems problems = problems_of(answer);
                   say(problems.empty() ? tr("The next run is recorded in '%1'").arg(files.front())
                                        : problems.front().message);
                 });
}

void MainWindow::copy_command() {
  workbench_.ask({{"do", "command"}}, [this](const Json& answer) {
    const QString text = QString::fromStdString(answer.value("text", std::string()));
    QApplication::clipboard()->setText(text);
    say(text.isEmpty() ? tr("There is no world yet.") : tr("Copied: %1").arg(text));
  });
}

void MainWindow::about() {
  QMessageBox::about(
      this, tr("About Elsie"),
      tr("<p><b>Elsie</b>: behaviour-based mobile robot control.</p><p>Apache License 2.0. This "
         "window uses Qt %1 (LGPL).</p>"
         "<p>The view is drawn by %2.</p>")
          .arg(qVersion(), scene_->device().isEmpty() ? tr("Qt, as outlines") : scene_->device()));
}

}  // namespace elsie::desktop
