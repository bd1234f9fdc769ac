#include "main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "export/exporter.h"
#include "recorded_world.h"
#include "scene/scene_view.h"
#include "start_page.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"
#include "world/properties.h"
#include "world/world_tree.h"

namespace elsie::desktop {
namespace {

constexpr int kMostRecent = 10;
constexpr int kSaid_ms = 8000;
constexpr qint64 kStuck_ms = 3000;
constexpr int kFewRobots = 16;  // that Plots shows all numbers of
constexpr QSize kSmallest(1280, 800);
constexpr int kWide = 1900;  // has room for the text beside the view

/// Most of a large screen, and 1280 x 800 on others.
QSize first_size() {
  const QSize room = QApplication::primaryScreen()->availableSize();
  return room.width() >= kWide ? (0.95 * room).expandedTo(kSmallest) : kSmallest;
}

/// The folder with the shipped worlds, of an installed program and of a build.
QString shipped_worlds() {
  const QDir folder(QApplication::applicationDirPath() + "/../share/elsie/worlds");
  return folder.exists() ? folder.canonicalPath() : QString();
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

  ask_for_run = [this](const QString& database) -> std::optional<int> {
    bool is_given = false;
    const int run = QInputDialog::getInt(
        this, tr("Open a run"), tr("Number of the run in '%1'").arg(QFileInfo(database).fileName()),
        1, 1, std::numeric_limits<int>::max(), 1, &is_given);
    return is_given ? std::optional(run) : std::nullopt;
  };

  centre_ = new QStackedWidget;
  start_ = new StartPage(shipped_worlds(), elsie);
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
  authoring_ = new Authoring(workbench_, scene_->stage(), this);
  exporter_ = new Exporter(workbench_, *scene_, *time_line_, this);

  make_actions();
  make_docks();
  make_menus();
  connect_workbench();
  connect_views();

  resize(first_size());
  arrange("author");
  default_state_ = saveState();
  QSettings settings;
  if (!restoreGeometry(settings.value("geometry").toByteArray())) {
    resize(first_size());
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
  connect_tree(world_tree_, {});
  for (const char* team : {"red", "blue"}) {
    make_team(team);
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
    // A dock that lies behind another is "visible", too.
    connect(docks_[name], &QDockWidget::visibilityChanged, this, [this, name](bool is_seen) {
      is_seen ? void(seen_.insert(name)) : void(seen_.remove(name));
      watch();
    });
  }
  connect(plots_, &PlotsPanel::choice_changed, this, &MainWindow::watch);
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
  for (const QString& team : std::as_const(teams_shown_)) trees << "team_" + team;
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
  if (layout == "author" && width() >= kWide) {
    put(Qt::RightDockWidgetArea, {"text"});
    addDockWidget(Qt::RightDockWidgetArea, docks_["properties"], Qt::Horizontal);
    columns << docks_["text"];
    widths << width() / 4;
  }
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
    for (const QString& path : authoring_->selection()) {
      if (place_of(workbench_.tree(), path).element || !path.contains('[')) still << path;
    }
    if (still != authoring_->selection()) authoring_->select(still);
    editor_->set_text(workbench_.text());
    if (watched_robot_.isEmpty() ||
        !place_of(workbench_.tree(), "robot[" + watched_robot_ + ']').element) {
      QString first;
      for (const Stage::Body& body : scene_->stage().bodies()) {
        if (first.isEmpty() && body.path.startsWith("robot[")) {
          first = body.path.mid(6, body.path.size() - 7);
        }
      }
      watch_robot(first);
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
    if (seen_.contains("coordination")) coordination_->add(state);
    if (seen_.contains("plots") || !plots_->chosen().isEmpty()) plots_->add(state);
    if (seen_.contains("vision")) vision_->add(state);
    if (seen_.contains("fuzzy")) fuzzy_->add(state);
    if (seen_.contains("sensors")) sensors_->add(state);
    for (WorldTree* each : findChildren<WorldTree*>()) {
      if (each->isVisible()) each->show_weights(state);
    }
    properties_->show_state(state);
  });
  connect(&workbench_, &Workbench::snapshot, this, [this](const snapshots::Snapshot& snapshot) {
    scene_->take(snapshot);
    show_pose();
    show_state();
  });
  connect(&workbench_, &Workbench::history_changed, this, [this] {
    const QString undo = workbench_.undo_name(), redo = workbench_.redo_name();
    actions_["undo"]->setText(undo.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(undo));
    actions_["undo"]->setToolTip(actions_["undo"]->text().remove('&'));
    actions_["undo"]->setEnabled(!undo.isEmpty());
    actions_["redo"]->setText(redo.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(redo));
    actions_["redo"]->setToolTip(actions_["redo"]->text().remove('&'));
    actions_["redo"]->setEnabled(!redo.isEmpty());
    show_title();
  });
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    if (workbench_.run_state() == Workbench::Run::ready) {
      outcome_.clear();
      scene_->clear_trails();
      time_line_->clear();
      coordination_->clear();
      plots_->begin();
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
    box->setInformativeText(cause_in(report));
    box->setDetailedText(report);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->open();
  });
  connect(&workbench_, &Workbench::changed_on_disk, this, &MainWindow::ask_about_disk);
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
          tr("The engine does not answer: a plugin takes long. 'Stop the engine now' in the menu "
             "Simulation names it, and begins anew."));
    }
  });
  watch_dog->start(1000);
}

void MainWindow::connect_views() {
  connect(scene_, &SceneView::selected, authoring_, &Authoring::select);
  connect(scene_, &SceneView::edit_wished, authoring_, &Authoring::edit_element);
  connect(scene_, &SceneView::menu_wished, authoring_, &Authoring::open_floor_menu);
  connect(scene_, &SceneView::element_menu_wished, authoring_, &Authoring::open_menu);
  connect(authoring_, &Authoring::called_otherwise, scene_, &SceneView::rename);
  connect(authoring_, &Authoring::called_otherwise, properties_, &Properties::rename);
  connect(scene_, &SceneView::run_wished, actions_["run"], &QAction::trigger);
  connect(scene_, &SceneView::moved, authoring_, &Authoring::move);
  connect(scene_, &SceneView::turned, authoring_, &Authoring::turn);
  connect(scene_, &SceneView::resized, authoring_, &Authoring::resize);
  connect(authoring_, &Authoring::selected, this, &MainWindow::show_selection);
  connect(authoring_, &Authoring::said, this, &MainWindow::say);
  connect(authoring_, &Authoring::follow_wished, scene_, &SceneView::follow);
  connect(exporter_, &Exporter::said, this, &MainWindow::say);
  connect(scene_, &SceneView::measured, this, [this](double x, double y, double to_x, double to_y) {
    say(tr("from (%1, %2) to (%3, %4): %5 m")
            .arg(x, 0, 'f', 3)
            .arg(y, 0, 'f', 3)
            .arg(to_x, 0, 'f', 3)
            .arg(to_y, 0, 'f', 3)
            .arg(std::hypot(to_x - x, to_y - y), 0, 'f', 3));
  });
  connect(editor_, &WorldEditor::edited, &workbench_, &Workbench::type);
  connect(&workbench_, &Workbench::about_to_change, editor_, &WorldEditor::commit);
  connect(editor_, &WorldEditor::undo_wished, &workbench_, &Workbench::undo);
  connect(editor_, &WorldEditor::redo_wished, &workbench_, &Workbench::redo);
  connect(problems_, &ProblemsPanel::go_to, this, &MainWindow::go_to);
  connect(start_, &StartPage::open_wished, this, [this](const QString& file) { open(file); });
  connect(start_, &StartPage::new_wished, actions_["new"], &QAction::trigger);
  connect(start_, &StartPage::empty_wished, this, [this] { begin_world(empty_world); });
  connect(start_, &StartPage::browse_wished, this, [this] { actions_["open"]->trigger(); });
}

// What the engine sends

void MainWindow::watch() {
  Json what = Json::array();
  const auto shows = [this](const char* name) { return seen_.contains(name); };
  const bool plots = shows("plots") || !plots_->chosen().isEmpty();
  const bool is_behavior =
      !authoring_->selection().isEmpty() && authoring_->selection().front().contains("/behavior[");
  if (shows("coordination") || plots || is_behavior) what.push_back("decisions");
  if (shows("sensors") || plots) what.push_back("sensors");
  if (plots) what.push_back("measures");
  if (shows("vision")) what.push_back("cameras");
  if (shows("fuzzy")) what.push_back("fuzzy");
  Json robots = Json::array();  // none: all
  const std::vector<Stage::Body>& bodies = scene_->stage().bodies();
  const bool are_few = std::count_if(bodies.begin(), bodies.end(), [](const Stage::Body& body) {
                         return body.is_robot();
                       }) <= kFewRobots;
  if (!shows("vision") && !(shows("plots") && are_few) && !watched_robot_.isEmpty()) {
    QStringList wished = plots_->chosen_robots();
    if (!wished.contains(watched_robot_)) wished << watched_robot_;
    for (const QString& id : std::as_const(wished)) {
      if (place_of(workbench_.tree(), "robot[" + id + ']').element) {
        robots.push_back(id.toStdString());
      }
    }
  }
  const Json order{{"do", "watch"}, {"what", what}, {"robots", robots}};
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
  editor_->commit();
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
  std::optional<std::uint64_t> seed;
  if (may_be_run(file)) {
    std::optional<int> number;
    if (may_be_database(file) && !(number = ask_for_run(file))) {
      return false;
    }
    const auto start = world_of_run(elsie_, options_, file, number, why);
    if (!start) {
      QMessageBox::warning(this, tr("The run cannot be opened"), why);
      return false;
    }
    world = start->file;
    seed = start->seed;
  }
  if (!workbench_.open(world, why, seed)) {
    QMessageBox::warning(this, tr("The world cannot be opened"), why);
    return false;
  }
  borrowed_ = world == file ? QString() : world;
  workbench_.set_borrowed(QFileInfo(borrowed_).absoluteFilePath());
  note_recent(file);
  forget_world();
  centre_->setCurrentIndex(1);
  scene_->setFocus();
  show_title();
  return true;
}

// What is only true of the world that was there.
void MainWindow::forget_world() {
  outcome_.clear();
  scene_->unlock_all();
  authoring_->select({});
  plots_->clear();
  vision_->clear();
  fuzzy_->clear();
  sensors_->clear();
}

void MainWindow::begin_world(const std::function<QString()>& text) {
  if (!may_leave()) {
    return;
  }
  const QString begun = text();
  if (!begun.isEmpty()) {
    borrowed_.clear();
    workbench_.open_text(begun, {}, false);
    forget_world();
    centre_->setCurrentIndex(1);
    show_title();
  }
}

bool MainWindow::save(bool elsewhere) {
  QString file = workbench_.file();
  if (elsewhere || file.isEmpty() || file == borrowed_) {
    QFileDialog dialog(
        this, tr("Save the world"),
        file.isEmpty() || file == borrowed_ ? QDir::currentPath() + "/world.xml" : file,
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
  // It may be saved after this has given up waiting.
  struct Saving {
    std::optional<QString> why;
    QEventLoop waiting;
  };
  const auto saving = std::make_shared<Saving>();
  workbench_.save_as(file, [this, saving](const QString& why) {
    saving->why = why;
    saving->waiting.quit();
    if (why.isEmpty()) {
      note_recent(workbench_.file());
      say(tr("Saved as '%1'").arg(workbench_.file()));
    }
    show_title();
  });
  if (!saving->why) {
    QTimer::singleShot(kStuck_ms, &saving->waiting, &QEventLoop::quit);
    saving->waiting.exec(QEventLoop::ExcludeUserInputEvents);
  }
  if (saving->why && saving->why->isEmpty()) {
    return true;
  }
  warn(tr("Not saved"), saving->why.value_or(tr(
                            "The engine does not answer: a plugin takes long. The world is saved "
                            "as soon as it does. 'Stop the engine now' in the menu Simulation "
                            "begins it anew; then save again.")));
  return false;
}

void MainWindow::warn(const QString& title, const QString& sentence) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, sentence, QMessageBox::Ok, this);
  box->setObjectName("warning");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

// Not modal to the event loop: a run goes on, and a file that changes again is asked about once.
void MainWindow::ask_about_disk() {
  if (findChild<QMessageBox*>("changed_on_disk")) {
    return;
  }
  auto* box = new QMessageBox(
      QMessageBox::Question, tr("The file has changed"),
      workbench_.is_modified()
          ? tr("Another program has changed '%1'. Read it again? What is unsaved here would be "
               "lost.")
                .arg(workbench_.file())
          : tr("Another program has changed '%1'. Read it again?").arg(workbench_.file()),
      QMessageBox::NoButton, this);
  box->setObjectName("changed_on_disk");
  box->setAttribute(Qt::WA_DeleteOnClose);
  QPushButton* again = box->addButton(tr("&Read again"), QMessageBox::AcceptRole);
  again->setObjectName("read_again");
  QPushButton* keep = box->addButton(tr("&Keep mine"), QMessageBox::RejectRole);
  keep->setObjectName("keep_mine");
  box->setEscapeButton(keep);
  const QString file = workbench_.file();
  connect(again, &QPushButton::clicked, this, [this, file] {
    QString why;
    if (file == workbench_.file() && !workbench_.open(file, why)) warn(tr("Not read"), why);
  });
  box->open();
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
    if (each.is_damaged) {
      warn(tr("Unsaved work"),
           tr("The unsaved work of a window that was not closed properly cannot be read. It is in "
              "'%1', and stays there.")
               .arg(each.kept_in));
      continue;
    }
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

void MainWindow::connect_tree(WorldTree* tree, const QString& team) {
  connect(tree, &WorldTree::selected, authoring_, &Authoring::select);
  connect(tree, &WorldTree::edit_wished, authoring_, &Authoring::edit_element);
  connect(tree, &WorldTree::add_wished, authoring_,
          [this, team](const QString& holder, const QString& list) {
            authoring_->add_element(holder, list, {{}, list == "robots" ? team : QString(), {}});
          });
  connect(tree, &WorldTree::behaviors_wished, authoring_, &Authoring::edit_behaviors);
  connect(tree, &WorldTree::menu_wished, authoring_, &Authoring::open_menu);
  for (const char* name : {"delete", "cut", "copy", "paste", "duplicate"}) {
    tree->addAction(actions_[name]);
  }
}

QDockWidget* MainWindow::make_team(const QString& team) {
  auto* tree = new WorldTree(workbench_, team);
  teams_[team] = tree;
  teams_shown_ << team;
  connect_tree(tree, team);
  return dock(("team_" + team).toUtf8().constData(), team, tree, Qt::LeftDockWidgetArea);
}

void MainWindow::show_teams() {
  for (const QString& team : teams_of(workbench_.tree())) {
    if (!teams_.contains(team)) {
      tabifyDockWidget(docks_["world"], make_team(team));
      docks_["world"]->raise();
    }
  }
}

void MainWindow::say(const QString& text) { statusBar()->showMessage(text, kSaid_ms); }

void MainWindow::show_pose() {
  if (const auto place = scene_->stage().place_of(properties_->path())) {
    properties_->show_pose(place->origin.x, place->origin.y, degrees(heading_rad(*place)));
  }
}

void MainWindow::show_selection(const QStringList& paths) {
  scene_->set_selection(paths);
  world_tree_->set_selection(paths);
  for (WorldTree* each : std::as_const(teams_)) each->set_selection(paths);
  properties_->show_element(paths.isEmpty() ? QString() : paths.front());
  show_pose();
  if (const QString robot = authoring_->robot(); !robot.isEmpty()) {
    watch_robot(robot.mid(6).chopped(1));
  }
  watch();
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
