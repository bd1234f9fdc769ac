#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QStyle>
#include <QToolBar>
#include <algorithm>
#include <array>
#include <utility>

#include "authoring/authoring.h"
#include "engine/past.h"
#include "main_window.h"
#include "scene/scene_view.h"
#include "text/problems_panel.h"
#include "text/sources_panel.h"
#include "text/world_editor.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/graph_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"
#include "world/properties.h"
#include "world/world_tree.h"

// The docks: which exist, where they are, and how their layout is restored.

namespace elsie::desktop {
namespace {

const QStringList kUsualTeams{"red", "blue"};
constexpr int kRoomy = 1200;    // px: in such a window the columns are wider
constexpr int kBelow = 184;     // px: three behaviours, or one plot
constexpr QSize kGrip(60, 12);  // the part of a title bar that a hand can grip

/// Whether a window at that place on the screens can be dragged by its title.
bool can_be_reached(const QRect& frame, int title_height) {
  const QRect title(frame.topLeft(), QSize(frame.width(), title_height));
  for (const QScreen* screen : QApplication::screens()) {
    const QRect seen = screen->availableGeometry() & title;
    if (seen.width() >= std::min(kGrip.width(), frame.width()) &&
        seen.height() >= std::min(kGrip.height(), title_height)) {
      return true;
    }
  }
  return false;
}

}  // namespace

QDockWidget* MainWindow::dock(const char* name, const QString& title, QWidget* widget,
                              Qt::DockWidgetArea area) {
  QDockWidget* made = new_dock(name, title, widget);
  addDockWidget(area, made);
  return made;
}

QDockWidget* MainWindow::new_dock(const char* name, const QString& title, QWidget* widget) {
  auto* made = new QDockWidget(title, this);
  made->setObjectName(QString("dock_") + name);
  made->setWidget(widget);
  connect(made->toggleViewAction(), &QAction::triggered, made, [made](bool is_shown) {
    if (is_shown) made->raise();
  });
  connect(made, &QDockWidget::visibilityChanged, this, [this, made](bool is_seen) {
    if (!is_start_shown_) {
      in_front_.removeAll(made->objectName());
      if (is_seen) in_front_ << made->objectName();
    }
  });
  return made;
}

void MainWindow::make_docks() {
  world_tree_ = new WorldTree(workbench_);
  docks_.world = dock("world", tr("World"), world_tree_, Qt::LeftDockWidgetArea);
  properties_ = new Properties(workbench_);
  docks_.properties = dock("properties", tr("Properties"), properties_, Qt::RightDockWidgetArea);
  connect_tree(world_tree_, {});
  for (const QString& team : kUsualTeams) {
    addDockWidget(Qt::LeftDockWidgetArea, make_team(team));
  }
  coordination_ = new CoordinationPanel;
  plots_ = new PlotsPanel;
  editor_ = new WorldEditor;
  problems_ = new ProblemsPanel;
  vision_ = new VisionPanel;
  fuzzy_ = new FuzzyPanel;
  sensors_ = new SensorsPanel;
  graph_ = new GraphPanel;
  docks_.coordination =
      dock("coordination", tr("Coordination"), coordination_, Qt::BottomDockWidgetArea);
  docks_.plots = dock("plots", tr("Plots"), plots_, Qt::BottomDockWidgetArea);
  docks_.text = dock("text", tr("Text"), editor_, Qt::BottomDockWidgetArea);
  docks_.problems = dock("problems", tr("Errors"), problems_, Qt::BottomDockWidgetArea);
  docks_.vision = dock("vision", tr("Vision"), vision_, Qt::RightDockWidgetArea);
  docks_.fuzzy = dock("fuzzy", tr("Fuzzy"), fuzzy_, Qt::RightDockWidgetArea);
  docks_.sensors = dock("sensors", tr("Sensors"), sensors_, Qt::RightDockWidgetArea);
  docks_.graph = dock("graph", tr("Graph"), graph_, Qt::RightDockWidgetArea);
  sources_ = new SourcesPanel;
  docks_.source = dock("source", tr("Source"), sources_, Qt::RightDockWidgetArea);
  docks_.source->hide();
  connect(sources_, &SourcesPanel::edited, this,
          [this] { workbench_.keep_sources(sources_->unsaved()); });
  for (QDockWidget* each : {docks_.coordination, docks_.plots, docks_.vision, docks_.fuzzy,
                            docks_.sensors, docks_.graph}) {
    // A dock behind another one also counts as "visible".
    connect(each, &QDockWidget::visibilityChanged, this, [this, each](bool is_seen) {
      is_seen ? void(seen_.insert(each)) : void(seen_.remove(each));
      watch();
    });
  }
  connect(plots_, &PlotsPanel::choice_changed, this, &MainWindow::watch);
  scene_->show_trails(*past_);
  const auto show_numbers = [this] {
    plots_->set_samples(past_->numbers());
    coordination_->set_samples(past_->numbers());
    graph_->set_samples(past_->numbers());
  };
  show_numbers();
  connect(past_, &Past::numbers_changed, this, show_numbers);
  connect(past_, &Past::named, this,
          [this](const QStringList& names, const QHash<QString, QString>& units) {
            plots_->set_names(names, units);
            request_past();
          });
}

QList<QDockWidget*> MainWindow::docks() const {
  QList<QDockWidget*> all{docks_.world,   docks_.properties, docks_.coordination, docks_.plots,
                          docks_.text,    docks_.problems,   docks_.vision,       docks_.fuzzy,
                          docks_.sensors, docks_.graph,      docks_.source};
  for (const QString& team : teams_shown_) all << teams_[team].dock;
  return all;
}

QList<WorldTree*> MainWindow::trees() const {
  QList<WorldTree*> all{world_tree_};
  for (const QString& team : teams_shown_) all << teams_[team].tree;
  return all;
}

// Docks that have nothing to show. The engine is asked for pictures, fuzzy models and graphs until
// it has sent some; where a world has none, asking costs nothing.

namespace {

/// What a robot of a state has for a dock.
constexpr const char* kPictures = "cameras";
constexpr const char* kModels = "fuzzy";
constexpr const char* kGraphs = "graphs";

}  // namespace

void MainWindow::put_away_empty() {
  for (QDockWidget* each : {docks_.vision, docks_.fuzzy, docks_.graph}) {
    if (!each->isHidden() || behind_start_.contains(each)) put_away(each);
  }
}

void MainWindow::put_away(QDockWidget* dock) {
  if (!filled_.contains(dock)) {
    behind_start_.removeAll(dock);
    dock->hide();
    away_.insert(dock);
  }
}

void MainWindow::bring_out(QDockWidget* dock) {
  filled_.insert(dock);
  if (away_.remove(dock)) {
    is_start_shown_ ? void(behind_start_ << dock) : dock->show();
    if (dock == first_) dock->raise();
  }
}

void MainWindow::bring_out_filled(const Json& state) {
  const std::array<std::pair<const char*, QDockWidget*>, 3> fillings{
      {{kPictures, docks_.vision}, {kModels, docks_.fuzzy}, {kGraphs, docks_.graph}}};
  bool has_news = false;
  for (const Json& robot : member(state, "robots")) {
    for (const auto& [what, dock] : fillings) {
      if (!filled_.contains(dock) && !member(robot, what).empty()) {
        bring_out(dock);
        has_news = true;
      }
    }
  }
  if (has_news) watch();
}

void MainWindow::ask_for_fillings(Json& what) const {
  if (!filled_.contains(docks_.vision)) what.push_back(kPictures);
  if (!filled_.contains(docks_.fuzzy)) what.push_back(kModels);
  if (!filled_.contains(docks_.graph)) what.push_back(kGraphs);
}

void MainWindow::show_page(bool is_start) {
  centre_->setCurrentIndex(is_start ? 0 : 1);
  if (is_start == is_start_shown_) {
    return;
  }
  if (is_start) {
    is_start_shown_ = true;
    for (QDockWidget* each : docks()) {
      if (!each->isHidden()) behind_start_ << each;
      each->hide();
    }
    return;
  }
  for (QDockWidget* each : std::exchange(behind_start_, {})) each->show();
  const QStringList in_front = in_front_;
  for (QDockWidget* each : docks()) {
    if (in_front.contains(each->objectName())) each->raise();
  }
  is_start_shown_ = false;
}

void MainWindow::arrange(const QString& layout) {
  const bool is_start = is_start_shown_ && !workbench_.tree().is_object();
  show_page(false);
  in_front_.clear();
  for (QDockWidget* each : docks()) {
    each->setFloating(false);
    each->hide();
  }
  away_.clear();
  const auto put = [this](Qt::DockWidgetArea area, const QList<QDockWidget*>& docks) {
    for (QDockWidget* each : docks) {
      addDockWidget(area, each);
      each->show();
      if (each != docks.front()) tabifyDockWidget(docks.front(), each);
    }
    docks.front()->raise();
    in_front_ << docks.front()->objectName();  // not yet seen in a window that is not shown yet
  };
  QList<QDockWidget*> trees{docks_.world};
  for (const QString& team : std::as_const(teams_shown_)) {
    if (!idle_teams_.contains(team)) trees << teams_[team].dock;
  }
  put(Qt::LeftDockWidgetArea, trees);
  const bool is_watch = layout == "watch";
  const QList<QDockWidget*> watching{docks_.vision, docks_.fuzzy, docks_.sensors, docks_.graph};
  put(Qt::RightDockWidgetArea, is_watch ? watching : QList{docks_.properties});
  QList<QDockWidget*> below{docks_.coordination, docks_.plots};
  if (!is_watch) below << docks_.text;
  if (layout == "author") below << docks_.problems;
  put(Qt::BottomDockWidgetArea, below);
  // Panels that are shown later are put behind the form, not into a strip below it.
  for (QDockWidget* each : is_watch ? QList<QDockWidget*>() : watching) {
    addDockWidget(Qt::RightDockWidgetArea, each);
    tabifyDockWidget(docks_.properties, each);
    each->hide();
  }
  for (QDockWidget* each : {docks_.vision, docks_.fuzzy, docks_.graph}) {
    put_away(each);
    if (filled_.contains(each) && !is_watch) each->show();
  }
  first_ = is_watch ? docks_.vision : nullptr;
  if (!is_watch) docks_.properties->raise();
  QList<QDockWidget*> columns{docks_.world};
  QList<int> widths{width() < kRoomy ? 220 : 240};
  if (layout == "author" && width() >= kWide) {
    put(Qt::RightDockWidgetArea, {docks_.text});
    addDockWidget(Qt::RightDockWidgetArea, docks_.properties, Qt::Horizontal);
    columns << docks_.text;
    widths << width() / 4;
  }
  columns << (is_watch ? docks_.vision : docks_.properties);
  widths << (is_watch ? std::max(420, width() / 4) : width() < kRoomy ? 280 : 300);
  resizeDocks(columns, widths, Qt::Horizontal);
  resizeDocks({docks_.coordination}, {kBelow}, Qt::Vertical);
  show_page(is_start);
}

void MainWindow::reset_layout() {
  const bool is_start = is_start_shown_;
  show_page(false);
  restoreState(default_state_);
  away_.clear();
  for (QDockWidget* each : {docks_.vision, docks_.fuzzy, docks_.graph}) {
    put_away(each);
    if (filled_.contains(each)) each->show();
  }
  docks_.properties->raise();
  show_page(is_start);
}

void MainWindow::connect_tree(WorldTree* tree, const QString& team) {
  connect(tree, &WorldTree::selected, authoring_, &Authoring::select);
  connect(tree, &WorldTree::list_selected, properties_, &Properties::show_list);
  connect(tree, &WorldTree::edit_wished, authoring_, &Authoring::edit_element);
  connect(
      tree, &WorldTree::add_wished, authoring_,
      [this, team](const QString& path, const QString& list) {
        const QString holder = list == "robots" ? QString() : authoring_->holder_for(list, path);
        list == "behaviors"
            ? authoring_->edit_behaviors(holder)
            : authoring_->add_element(holder, list, {{}, list == "robots" ? team : QString(), {}});
      });
  connect(tree, &WorldTree::menu_wished, authoring_, &Authoring::open_menu);
  connect(tree, &WorldTree::list_menu_wished, authoring_, &Authoring::open_list_menu);
  tree->addActions({actions_.remove, actions_.cut, actions_.copy, actions_.paste});
}

QDockWidget* MainWindow::make_team(const QString& team) {
  auto* tree = new WorldTree(workbench_, team);
  QDockWidget* made = new_dock(("team_" + team).toUtf8().constData(), team, tree);
  teams_[team] = {tree, made};
  teams_shown_ << team;
  connect_tree(tree, team);
  tree->show_locked(scene_->locked());
  return made;
}

// The windows of the two usual teams are hidden in a world that has other teams and no robot in
// them; those of other teams exist only for worlds that have them.
void MainWindow::show_teams() {
  if (!workbench_.tree().is_object()) {
    return;
  }
  const QStringList teams = teams_of(workbench_.tree());
  for (const QString& team : QStringList(teams_shown_)) {
    if (!teams.contains(team) && !kUsualTeams.contains(team)) {
      teams_shown_.removeAll(team);
      QDockWidget* gone = teams_.take(team).dock;
      behind_start_.removeAll(gone);
      removeDockWidget(gone);
      gone->deleteLater();
    }
  }
  for (const QString& team : teams) {
    if (!teams_.contains(team)) {
      QDockWidget* made = make_team(team);
      if (!restoreDockWidget(made)) {
        addDockWidget(Qt::LeftDockWidgetArea, made);
        tabifyDockWidget(docks_.world, made);
        docks_.world->raise();
      }
      bring_back(made);
    }
  }
  const bool has_others = std::any_of(
      teams.begin(), teams.end(), [](const QString& team) { return !kUsualTeams.contains(team); });
  for (const QString& team : kUsualTeams) {
    const bool is_idle = has_others && !teams.contains(team);
    QDockWidget* window = teams_[team].dock;
    if (is_idle && !window->isHidden()) {
      window->hide();
      idle_teams_ << team;
    } else if (!is_idle && idle_teams_.remove(team)) {
      window->show();
    }
  }
}

// Moves a window that was left on a screen that no longer exists.
void MainWindow::bring_back(QDockWidget* dock) {
  const int title = style()->pixelMetric(QStyle::PM_TitleBarHeight, nullptr, dock);
  if (dock->isFloating() && !can_be_reached(dock->frameGeometry(), title)) {
    dock->move(pos() + QPoint(40, 40));
  }
}

void MainWindow::showEvent(QShowEvent* event) {
  QMainWindow::showEvent(event);
  if (!was_shown_) {
    was_shown_ = true;
    for (QDockWidget* each : docks()) {
      bring_back(each);
    }
  }
}

// Some window managers put the window before its own floating ones when it is activated.
void MainWindow::changeEvent(QEvent* event) {
  QMainWindow::changeEvent(event);
  if (event->type() == QEvent::ActivationChange && isActiveWindow()) {
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
      if (each->isFloating() && each->isVisible()) each->raise();
    }
  }
}

void MainWindow::keep_layout() {
  show_page(false);
  for (const QString& team : idle_teams_) {
    teams_[team].dock->show();  // it is not the user who closed it
  }
  for (QDockWidget* each : std::as_const(away_)) each->show();  // likewise
  QSettings settings;
  settings.setValue("plots", plots_->choice());
  settings.setValue("status_bar", !statusBar()->isHidden());
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", saveState());
  settings.setValue("in_front", in_front_);
}

}  // namespace elsie::desktop
