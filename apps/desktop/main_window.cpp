#include "main_window.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStyle>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "engine/past.h"
#include "export/exporter.h"
#include "export/sharer.h"
#include "recorded_world.h"
#include "scene/scene_view.h"
#include "start_page.h"
#include "watch/plots_panel.h"
#include "watch/run_card.h"
#include "world/properties.h"
#include "world/world_tree.h"

// The window, and how it shows the world and the run.

namespace elsie::desktop {
namespace {

constexpr int kSaid_ms = 8000;
constexpr QSize kUsual(1280, 800);

/// The largest title and borders that window managers use.
QSize usual_frame(const QStyle& style) {
  constexpr int kBorder = 8;
  return {2 * kBorder, style.pixelMetric(QStyle::PM_TitleBarHeight) + 2 * kBorder};
}

/// The folder with the shipped worlds, of an installed program or of a build.
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

  centre_ = new QStackedWidget;
  start_ = new StartPage(shipped_worlds(), elsie);
  auto* view = new QWidget;
  auto* column = new QVBoxLayout(view);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  past_ = new Past(workbench_, this);
  scene_ = new SceneView;
  run_card_ = new RunCard(scene_);
  stuck_notice_ = new StuckNotice(scene_);
  time_line_ = new TimeLine(workbench_);
  column->addWidget(scene_, 1);
  column->addWidget(time_line_);
  centre_->addWidget(start_);
  centre_->addWidget(view);
  setCentralWidget(centre_);
  authoring_ = new Authoring(workbench_, *scene_, this);
  exporter_ = new Exporter(workbench_, *scene_, *time_line_, *past_, this);
  sharer_ = new Sharer(workbench_, elsie, options, this);
  runs_ = new RunReader(elsie, options, this);

  make_menus();
  make_status_bar();
  make_docks();
  connect_workbench();
  connect_views();
  connect_cards();

  const QSize first =
      first_size(QApplication::primaryScreen()->availableSize(), usual_frame(*style()));
  resize(first);
  arrange("author");
  default_state_ = saveState();
  QSettings settings;
  if (!restoreGeometry(settings.value("geometry").toByteArray())) {
    resize(first);
  }
  if (restoreState(settings.value("layout").toByteArray())) {
    in_front_ = settings.value("in_front").toStringList();
  }
  put_away_empty();
  plots_->set_choice(settings.value("plots").toStringList());
  actions_.status_bar->setChecked(settings.value("status_bar", true).toBool());
  show_recent();
  show_state();
  show_title();
  show_page(true);
}

QSize MainWindow::first_size(const QSize& room, const QSize& frame) {
  const QSize wished = room.width() >= kWide ? (0.95 * room).expandedTo(kUsual) : kUsual;
  return wished.boundedTo(room - frame);
}

// Deletes the views before the objects that they show.
MainWindow::~MainWindow() {
  const QList<QDockWidget*> all = findChildren<QDockWidget*>();
  for (QDockWidget* each : all) {
    each->disconnect(this);
  }
  time_line_->disconnect(this);
  workbench_.disconnect(this);
  qDeleteAll(findChildren<QDialog*>(Qt::FindDirectChildrenOnly));
  qDeleteAll(findChildren<QToolBar*>(Qt::FindDirectChildrenOnly));
  qDeleteAll(all);
  delete takeCentralWidget();
}

// What is shown

void MainWindow::show_title() {
  const QString name =
      workbench_.file().isEmpty() ? tr("new world") : QFileInfo(workbench_.file()).fileName();
  setWindowTitle(
      (workbench_.text().isEmpty() && workbench_.file().isEmpty() ? QString() : name + "[*] - ") +
      "Elsie");
  setWindowModified(workbench_.is_modified() && !workbench_.text().isEmpty());
  enable_commands();
}

void MainWindow::enable_commands() {
  const bool has_world = workbench_.tree().is_object();
  with_world_->setEnabled(has_world);
  boxes_->setEnabled(has_world);
  with_text_->setEnabled(!workbench_.text().isEmpty() || !workbench_.file().isEmpty());
  const auto name = [](QAction& action, const QString& title, const QString& edit) {
    action.setText(edit.isEmpty() ? title : tr("%1: %2").arg(title, edit));
    action.setToolTip(action.text().remove('&'));
    action.setEnabled(!edit.isEmpty());
  };
  name(*actions_.undo, tr("&Undo"), workbench_.undo_name());
  name(*actions_.redo, tr("&Redo"), workbench_.redo_name());
}

void MainWindow::show_state() {
  time_label_->setText(tr("%1 s").arg(workbench_.time_s(), 0, 'f', 2));
  const QString wanted =
      workbench_.speed() > 0.0 ? QString::number(workbench_.speed()) + 'x' : tr("maximum");
  pace_label_->setText(
      workbench_.run_state() == Workbench::Run::running
          ? tr("%1x of %2").arg(is_stuck_ ? 0.0 : workbench_.pace(), 0, 'f', 1).arg(wanted)
          : wanted);
  seed_label_->setText(tr("seed %1").arg(workbench_.seed()));
  const QHash<Workbench::Run, QString> words{{Workbench::Run::none, tr("no world")},
                                             {Workbench::Run::ready, tr("ready")},
                                             {Workbench::Run::running, tr("running")},
                                             {Workbench::Run::paused, tr("paused")},
                                             {Workbench::Run::ended, tr("ended")}};
  const QString word = workbench_.is_opening()    ? tr("opening the world")
                       : is_stuck_                ? tr("no answer")
                       : time_line_->is_playing() ? tr("playing the past")
                                                  : words.value(workbench_.run_state());
  const bool is_over = !outcome_.isEmpty() && !time_line_->is_playing();
  const QHash<QString, QString> ends{{"success", tr("success")},
                                     {"failure", tr("failure")},
                                     {"time_limit", tr("time is up")},
                                     {"no_goals", tr("no goals")},
                                     {"stopped", tr("stopped")}};
  outcome_label_->setText(is_over ? word + ": " + ends.value(outcome_, outcome_) : word);
  const bool is_recorded = recorded_ && workbench_.is_borrowed();
  recording_label_->setVisible(is_recorded);
  if (is_recorded) {
    const QString verdict = recorded() ? recorded_->verdict : tr("changed");
    recording_label_->setText(verdict.isEmpty()
                                  ? tr("recording %1").arg(recorded_->title)
                                  : tr("recording %1, %2").arg(recorded_->title, verdict));
  }
}

void MainWindow::say(const QString& text) {
  statusBar()->showMessage(text, kSaid_ms);
  statusBar()->setToolTip(text);  // a narrow window cuts it off
}

void MainWindow::show_pose() {
  if (const auto place = scene_->stage().place_of(properties_->path())) {
    properties_->show_pose(place->origin.x, place->origin.y, degrees(heading_rad(*place)));
  }
}

void MainWindow::show_lock() {
  const bool is_locked = scene_->locked().contains(authoring_->selection().value(0));
  actions_.lock->setText(is_locked ? tr("Unloc&k for the mouse") : tr("Loc&k against the mouse"));
}

void MainWindow::show_selection(const QStringList& paths) {
  world_tree_->set_selection(paths);
  for (const Team& each : std::as_const(teams_)) each.tree->set_selection(paths);
  properties_->show_element(paths.isEmpty() ? QString() : paths.front());
  show_lock();
  show_pose();
  if (const QString robot = authoring_->robot(); !robot.isEmpty()) {
    watch_robot(robot_id(robot));
  }
  watch();
}

void MainWindow::about() {
  QMessageBox::about(
      this, tr("About Elsie"),
      tr("<p><b>Elsie %3</b>: behaviour-based mobile robot control.</p><p>Apache License 2.0. This "
         "window uses Qt %1 (LGPL).</p>"
         "<p>The view is drawn by %2.</p>")
          .arg(qVersion(), scene_->device().isEmpty() ? tr("Qt, as outlines") : scene_->device(),
               ELSIE_VERSION));
}

}  // namespace elsie::desktop
