#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>
#include <algorithm>

#include "authoring/authoring.h"
#include "engine/past.h"
#include "main_window.h"
#include "scene/scene_view.h"
#include "text/problems_panel.h"
#include "text/world_editor.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/plots_panel.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"
#include "world/properties.h"
#include "world/world_tree.h"

// The docks: which exist, where they are, and how their layout is restored.

namespace elsie::desktop {
namespace {

const QStringList kUsualTeams{"red", "blue"};
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
  docks_[name] = made;
  connect(made->toggleViewAction(), &QAction::triggered, made, [made](bool is_shown) {
    if (is_shown) made->raise();
  });
  return made;
}

void MainWindow::make_docks() {
  world_tree_ = new WorldTree(workbench_);
  dock("world", tr("World"), world_tree_, Qt::LeftDockWidgetArea);
  properties_ = new Properties(workbench_);
  dock("properties", tr("Properties"), properties_, Qt::RightDockWidgetArea);
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
  dock("coordination", tr("Coordination"), coordination_, Qt::BottomDockWidgetArea);
  dock("plots", tr("Plots"), plots_, Qt::BottomDockWidgetArea);
  dock("text", tr("Text"), editor_, Qt::BottomDockWidgetArea);
  dock("problems", tr("Errors"), problems_, Qt::BottomDockWidgetArea);
  dock("vision", tr("Vision"), vision_, Qt::RightDockWidgetArea);
  dock("fuzzy", tr("Fuzzy"), fuzzy_, Qt::RightDockWidgetArea);
  dock("sensors", tr("Sensors"), sensors_, Qt::RightDockWidgetArea);
  for (const char* name : {"coordination", "plots", "vision", "fuzzy", "sensors"}) {
    // A dock behind another one also counts as "visible".
    connect(docks_[name], &QDockWidget::visibilityChanged, this, [this, name](bool is_seen) {
      is_seen ? void(seen_.insert(name)) : void(seen_.remove(name));
      watch();
    });
  }
  connect(plots_, &PlotsPanel::choice_changed, this, &MainWindow::watch);
  scene_->show_trails(*past_);
  const auto show_numbers = [this] {
    plots_->set_samples(past_->numbers());
    coordination_->set_samples(past_->numbers());
  };
  show_numbers();
  connect(past_, &Past::numbers_changed, this, show_numbers);
  connect(past_, &Past::named, this, [this](const QStringList& names) {
    plots_->set_names(names);
    request_past();
  });
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
  for (const QString& team : std::as_const(teams_shown_)) {
    if (!idle_teams_.contains(team)) trees << "team_" + team;
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
  // Panels that are shown later are put behind the form, not into a strip below it.
  for (const char* name : {"vision", "fuzzy", "sensors"}) {
    if (layout != "watch") {
      addDockWidget(Qt::RightDockWidgetArea, docks_[name]);
      tabifyDockWidget(docks_["properties"], docks_[name]);
      docks_[name]->hide();
    }
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
    widths << (layout == "watch" ? std::max(420, width() / 4) : 280);
  }
  resizeDocks(columns, widths, Qt::Horizontal);
  if (QDockWidget* bottom = docks_.value("coordination")) {
    resizeDocks({bottom}, {170}, Qt::Vertical);
  }
}

void MainWindow::connect_tree(WorldTree* tree, const QString& team) {
  connect(tree, &WorldTree::selected, authoring_, &Authoring::select);
  connect(tree, &WorldTree::list_selected, properties_, &Properties::show_list);
  connect(tree, &WorldTree::edit_wished, authoring_, &Authoring::edit_element);
  connect(tree, &WorldTree::add_wished, authoring_,
          [this, team](const QString& holder, const QString& list) {
            authoring_->add_element(holder, list, {{}, list == "robots" ? team : QString(), {}});
          });
  connect(tree, &WorldTree::behaviors_wished, authoring_, &Authoring::edit_behaviors);
  connect(tree, &WorldTree::menu_wished, authoring_, &Authoring::open_menu);
  for (const char* name : {"delete", "cut", "copy", "paste"}) {
    tree->addAction(actions_[name]);
  }
}

QDockWidget* MainWindow::make_team(const QString& team) {
  auto* tree = new WorldTree(workbench_, team);
  teams_[team] = tree;
  teams_shown_ << team;
  connect_tree(tree, team);
  tree->show_locked(scene_->locked());
  return new_dock(("team_" + team).toUtf8().constData(), team, tree);
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
      teams_.remove(team);
      QDockWidget* gone = docks_.take("team_" + team);
      removeDockWidget(gone);
      gone->deleteLater();
    }
  }
  for (const QString& team : teams) {
    if (!teams_.contains(team)) {
      QDockWidget* made = make_team(team);
      if (!restoreDockWidget(made)) {
        addDockWidget(Qt::LeftDockWidgetArea, made);
        tabifyDockWidget(docks_["world"], made);
        docks_["world"]->raise();
      }
      bring_back(made);
    }
  }
  const bool has_others = std::any_of(
      teams.begin(), teams.end(), [](const QString& team) { return !kUsualTeams.contains(team); });
  for (const QString& team : kUsualTeams) {
    const bool is_idle = has_others && !teams.contains(team);
    QDockWidget* window = docks_["team_" + team];
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
    for (QDockWidget* each : findChildren<QDockWidget*>()) {
      bring_back(each);
    }
  }
}

void MainWindow::keep_layout() const {
  for (const QString& team : idle_teams_) {
    docks_["team_" + team]->show();  // it is not the user who closed it
  }
  QSettings settings;
  settings.setValue("plots", plots_->choice());
  settings.setValue("status_bar", !statusBar()->isHidden());
  settings.setValue("geometry", saveGeometry());
  settings.setValue("layout", saveState());
}

}  // namespace elsie::desktop
