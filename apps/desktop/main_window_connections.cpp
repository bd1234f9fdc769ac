#include <QAction>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "authoring/authoring.h"
#include "control_bar.h"
#include "engine/past.h"
#include "export/exporter.h"
#include "export/sharer.h"
#include "main_window.h"
#include "paint/warning_label.h"
#include "recorded_world.h"
#include "scene/scene_view.h"
#include "start_page.h"
#include "text/problems_panel.h"
#include "text/sources_panel.h"
#include "text/world_editor.h"
#include "watch/coordination_panel.h"
#include "watch/fuzzy_panel.h"
#include "watch/graph_panel.h"
#include "watch/plots_panel.h"
#include "watch/reasons.h"
#include "watch/run_card.h"
#include "watch/sensors_panel.h"
#include "watch/vision_panel.h"
#include "world/form.h"
#include "world/properties.h"
#include "world/world_tree.h"

// How the window reacts to the workbench and the views, and what it asks the engine to send.

namespace elsie::desktop {
namespace {

constexpr int kFewRobots = 16;  // with more, Plots shows the numbers of one robot

}  // namespace

// Connections

void MainWindow::connect_workbench() {
  connect(&workbench_, &Workbench::described, this, [this] {
    if (statusBar()->currentMessage() == std::exchange(opening_, QString())) {
      statusBar()->clearMessage();
    }
    if (workbench_.tree().is_object() && !is_start_wished_) show_page(false);
    scene_->set_scene(workbench_.scene(), workbench_.epoch());
    scene_->set_notice(notice());
    show_pose();
    world_tree_->show_world();
    show_teams();
    for (const Team& each : std::as_const(teams_)) each.tree->show_world();
    QStringList still;
    for (const QString& path : authoring_->selection()) {
      if (place_of(workbench_.tree(), path).element || !path.contains('[')) still << path;
    }
    if (still != authoring_->selection()) authoring_->select(still);
    editor_->set_text(workbench_.text());
    if (watched_robot_.isEmpty() ||
        !place_of(workbench_.tree(), "robot[" + watched_robot_ + ']').element) {
      const std::vector<Stage::Body>& bodies = scene_->stage().bodies();
      const auto first =
          std::find_if(bodies.begin(), bodies.end(), std::mem_fn(&Stage::Body::is_robot));
      watch_robot(first == bodies.end() ? QString() : robot_id(first->path));
    }
    watch();
    show_title();
    show_state();
  });
  connect(&workbench_, &Workbench::problems_changed, this, &MainWindow::show_problems);
  connect(&workbench_, &Workbench::state, this, [this](const Json& state) {
    if (seen_.contains(docks_.coordination)) coordination_->add(state);
    if (seen_.contains(docks_.vision)) vision_->add(state);
    if (seen_.contains(docks_.fuzzy)) fuzzy_->add(state);
    if (seen_.contains(docks_.sensors)) sensors_->add(state);
    if (seen_.contains(docks_.graph)) graph_->add(state);
    if (seen_.contains(docks_.coordination) || seen_.contains(docks_.graph)) request_past();
    bring_out_filled(state);
    if (!time_line_->is_in_the_past()) show_values(state);
    scene_->take_state(state);
  });
  connect(&workbench_, &Workbench::snapshot, this, [this](const snapshots::Snapshot& snapshot) {
    scene_->take(snapshot);
    show_looked_back();
    show_pose();
    show_state();
  });
  connect(&workbench_, &Workbench::history_changed, this, &MainWindow::show_title);
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    if (workbench_.run_state() == Workbench::Run::ready) {
      outcome_.clear();
      failure_.clear();
      show_problems();
      fuzzy_->read_again();  // as the run does
      scene_->begin_trails_at(0.0);
      time_line_->clear();
      coordination_->clear();
    }
    show_state();
  });
  connect(&workbench_, &Workbench::settings_changed, this, &MainWindow::show_state);
  connect(&workbench_, &Workbench::came_to, this, &MainWindow::compare_with_recording);
  connect(&workbench_, &Workbench::ended, this, &MainWindow::compare_with_recording);
  connect(&workbench_, &Workbench::went_on, this, [this] {
    if (workbench_.has_mistakes()) {
      say(tr("The text has mistakes: the world is the one from before them."));
    }
  });
  connect(&workbench_, &Workbench::ended, this, [this](const Json& end) {
    const QString reason = text_of(end, "reason");
    outcome_ = text_of(end, "outcome");
    outcome_label_->setToolTip(tr("%1\nstate hash %2").arg(reason, text_of(end, "state_hash")));
    const QString words = outcome_words(end);
    say(outcome_ == "stopped" && !reason.isEmpty() ? words + ": " + reason : words + '.');
    if (outcome_ == "stopped") {
      failure_ = reason;
      show_problems();  // where it can be read whole
    }
    show_state();
  });
  connect(&workbench_, &Workbench::raised, this, [this](const Json& event) {
    time_line_->mark(event.value("time_s", 0.0), text_of(event, "name"));
  });
  connect(&workbench_, &Workbench::noted, this, &MainWindow::say);
  connect(&workbench_, &Workbench::refused, this, [this](const Problems& problems) {
    if (!problems.empty()) say(problems.front().message);
  });
  connect(&workbench_, &Workbench::engine_lost, this, &MainWindow::say_that_the_engine_ended);
  connect(&workbench_, &Workbench::changed_on_disk, this, &MainWindow::ask_about_disk);
  connect(&workbench_, &Workbench::catalog_changed, this, [this] {
    world_tree_->show_world();
    editor_->set_catalog(workbench_.catalog());
    if (!statusBar()->currentMessage().isEmpty()) return;  // which says more
    say(tr("%1 plugins were found")
            .arg(workbench_.catalog().json().value("plugins", Json::array()).size()));
  });
  auto* watch_dog = new QTimer(this);
  connect(watch_dog, &QTimer::timeout, this, [this] {
    const qint64 waiting_ms = workbench_.engine().waiting_ms();
    if (workbench_.run_state() == Workbench::Run::running && waiting_ms == 0) {
      workbench_.ask({{"do", "ping"}}, {});  // a run that hangs answers nothing
    }
    if (const bool is_stuck = waiting_ms > kStuck_ms; is_stuck != is_stuck_) {
      is_stuck_ = is_stuck;
      show_state();
      if (!is_stuck) statusBar()->clearMessage();
    }
    if (is_stuck_ && workbench_.is_opening()) {
      statusBar()->showMessage(
          tr("The engine has been reading the world for %1 s: it is large, or a plugin takes long. "
             "'Stop the engine now' in the menu Simulation stops it, and the text stays.")
              .arg(waiting_ms / 1000));
    } else if (is_stuck_) {
      statusBar()->showMessage(
          tr("The engine does not answer: a plugin takes long. 'Stop the engine now' in the menu "
             "Simulation starts it again, and the world stays."));
    }
  });
  watch_dog->start(1000);
}

void MainWindow::connect_views() {
  connect(scene_, &SceneView::locks_changed, this, [this] {
    for (WorldTree* each : trees()) each->show_locked(scene_->locked());
    show_lock();
  });
  connect(authoring_, &Authoring::called_otherwise, properties_, &Properties::rename);
  connect(scene_, &SceneView::run_wished, this, &MainWindow::run_or_pause);
  connect(time_line_, &TimeLine::past_changed, this, &MainWindow::show_past);
  connect(time_line_, &TimeLine::instant_changed, this, &MainWindow::show_instant);
  connect(plots_, &PlotsPanel::time_wished, time_line_, &TimeLine::go_to);
  connect(coordination_, &CoordinationPanel::time_wished, time_line_, &TimeLine::go_to);
  connect(time_line_, &TimeLine::has_caught_up, this, [this] {
    if (workbench_.run_state() == Workbench::Run::paused && !workbench_.is_at_halt()) {
      workbench_.run();
    }
  });
  connect(authoring_, &Authoring::selected, this, &MainWindow::show_selection);
  connect(properties_, &Properties::add_wished, authoring_,
          [this](const QString& holder, const QString& list) {
            list == "behaviors" ? authoring_->edit_behaviors(holder)
                                : authoring_->add_element(holder, list);
          });
  connect(authoring_, &Authoring::said, this, &MainWindow::say);
  connect(authoring_, &Authoring::moved_in_the_past, this, [this] {
    time_line_->go_to_now();
    say(tr("The view showed the past, in which nothing can be changed. Now it shows the present."));
  });
  connect(exporter_, &Exporter::said, this, &MainWindow::say);
  connect(sharer_, &Sharer::said, this, &MainWindow::say);
  connect(scene_, &SceneView::measured, this, [this](double x, double y, double to_x, double to_y) {
    say(tr("from (%1, %2) to (%3, %4): %5 m")
            .arg(x, 0, 'f', 3)
            .arg(y, 0, 'f', 3)
            .arg(to_x, 0, 'f', 3)
            .arg(to_y, 0, 'f', 3)
            .arg(std::hypot(to_x - x, to_y - y), 0, 'f', 3));
  });
  connect(editor_, &WorldEditor::edited, &workbench_, &Workbench::type);
  connect(&workbench_, &Workbench::about_to_change, this, &MainWindow::enter_what_is_typed);
  connect(editor_, &WorldEditor::undo_wished, &workbench_, &Workbench::undo);
  connect(editor_, &WorldEditor::redo_wished, &workbench_, &Workbench::redo);
  connect(problems_, &ProblemsPanel::go_to, this, &MainWindow::go_to);
  connect(start_, &StartPage::open_wished, this, [this](const QString& file) { open(file); });
  connect(start_, &StartPage::new_wished, actions_.new_world, &QAction::trigger);
  connect(start_, &StartPage::empty_wished, this, [this] { begin_world(empty_world); });
  connect(start_, &StartPage::browse_wished, actions_.open, &QAction::trigger);
  connect(runs_, &RunReader::failed, this, [this](const QString& why) {
    statusBar()->clearMessage();  // "Reading..."
    warn(this, tr("The run cannot be opened"), why);
  });
}

void MainWindow::connect_cards() {
  connect(&workbench_, &Workbench::stuck, stuck_notice_, &StuckNotice::take);
  connect(&workbench_, &Workbench::snapshot, this,
          [this] { stuck_notice_->show_time(workbench_.latest_s()); });
  connect(&workbench_, &Workbench::ended, this, [this](const Json& end) {
    stuck_notice_->clear();
    run_card_->show_end(end);
  });
  connect(&workbench_, &Workbench::run_changed, this, [this] {
    const Workbench::Run state = workbench_.run_state();
    if (state == Workbench::Run::none || state == Workbench::Run::ready) {
      stuck_notice_->clear();
      run_card_->hide();
    }
  });
  connect(stuck_notice_, &StuckNotice::robot_wished, this,
          [this](const QString& id) { authoring_->select({"robot[" + id + ']'}); });
  connect(run_card_, &RunCard::again_wished, this, [this] { run_with(workbench_.seed()); });
  connect(run_card_, &RunCard::next_wished, this, [this] { run_with(workbench_.seed() + 1); });
  connect(run_card_, &RunCard::said, this, &MainWindow::say);
  connect(&workbench_, &Workbench::plugins_changed, this, &MainWindow::take_plugins);
  connect(sources_, &SourcesPanel::model_saved, this, &MainWindow::take_saved_model);
  connect(fuzzy_, &FuzzyPanel::edit_wished, this,
          [this](const QString& file) { open_source(file, 0); });
  connect(sources_, &SourcesPanel::failed, this,
          [this](const QString& why) { warn(this, tr("Source"), why, "source_failed"); });
  connect(sources_, &SourcesPanel::close_wished, this, [this](const QString& file) {
    const bool is_modified = sources_->modified().contains(file);
    if (may_leave_sources(is_modified ? QStringList{file} : QStringList())) {
      sources_->close_tab(file);
    }
  });
}

void MainWindow::show_end() {
  if (workbench_.run_state() != Workbench::Run::ended) {
    say(tr("The run has not ended."));
    return;
  }
  run_card_->open();
  run_card_->setFocus();
}

void MainWindow::run_with(quint64 seed) {
  workbench_.reset(seed);
  workbench_.run();
  scene_->setFocus();
}

void MainWindow::enter_what_is_typed() {
  editor_->commit();
  properties_->form().finish();
}

// Problems

bool MainWindow::is_of_world(const QString& file) const {
  return file.isEmpty() ||
         (!workbench_.file().isEmpty() && QFileInfo(file) == QFileInfo(workbench_.file()));
}

void MainWindow::show_problems() {
  editor_->set_text(workbench_.text());
  Problems all = workbench_.problems();
  const Problems remarks = workbench_.remarks();
  all.insert(all.end(), remarks.begin(), remarks.end());
  if (!failure_.isEmpty()) {
    all.push_back({{}, 0, tr("The run failed: %1").arg(failure_)});
  }
  if (all == problems_shown_) {
    return;
  }
  const bool has_news = std::any_of(all.begin(), all.end(), [this](const Problem& each) {
    return !each.is_warning &&
           std::find(problems_shown_.begin(), problems_shown_.end(), each) == problems_shown_.end();
  });
  problems_shown_ = all;
  problems_->set_problems(all);
  docks_.problems->setWindowTitle(all.empty() ? tr("Errors") : tr("Errors (%1)").arg(all.size()));
  std::erase_if(all,
                [this](const Problem& each) { return each.line <= 0 || !is_of_world(each.file); });
  editor_->set_problems(all);
  sources_->set_problems(problems_shown_);
  scene_->set_notice(notice());
  if (has_news && !editor_->hasFocus()) {
    docks_.problems->show();
    docks_.problems->raise();
    if (workbench_.tree().is_null()) {  // it is mended in its text
      docks_.text->show();
      docks_.text->raise();
      if (!all.empty() && all.front().line > 0) editor_->go_to(all.front().line);
    }
  }
}

/// What the view says instead of a world.
QString MainWindow::notice() const {
  const auto count =
      std::count_if(problems_shown_.begin(), problems_shown_.end(),
                    [](const Problem& each) { return !each.is_warning && each.line > 0; });
  if (workbench_.tree().is_object() || count == 0) {
    return {};
  }
  return count == 1 ? tr("The text is not a world yet: it has an error.")
                    : tr("The text is not a world yet: it has %1 errors.").arg(count);
}

void MainWindow::go_to(const QString& file, int line) {
  if (line <= 0 && file.isEmpty()) {
    docks_.problems->raise();  // it has no place
    return;
  }
  if (!is_of_world(file)) {
    open_source(file, line);
    return;
  }
  docks_.text->show();
  docks_.text->raise();
  editor_->go_to(line);
}

/// There is only one box, however often the engine ends.
void MainWindow::say_that_the_engine_ended(const QString& report, bool was_stopped,
                                           const QStringList& not_made) {
  QMessageBox* box = engine_lost_;
  if (!box) {
    box = engine_lost_ = new QMessageBox(this);
    box->setObjectName("engine_lost");
    box->setStandardButtons(QMessageBox::Ok);
    box->setAttribute(Qt::WA_DeleteOnClose);
  }
  const bool is_there = workbench_.engine().is_there();
  box->setIcon(is_there && was_stopped ? QMessageBox::Information : QMessageBox::Warning);
  box->setWindowTitle(!is_there     ? tr("There is no engine")
                      : was_stopped ? tr("The engine was stopped")
                                    : tr("The engine was started again"));
  const QString what = was_stopped            ? tr("You stopped the engine.")
                       : names_plugin(report) ? tr("A plugin ended the engine.")
                                              : tr("The engine ended.");
  box->setText(
      what + ' ' +
      (!is_there
           ? tr("It does not start again. Your world and its unsaved changes are here as a text, "
                "which you can save. Changing the text, or opening a world, tries to start the "
                "engine again.")
       : workbench_.tree().is_null() && !workbench_.problems().empty()
           ? tr("Your world and its unsaved changes are here as a text, which is opened again "
                "when you change it.")
           : tr("Your world and its unsaved changes are here; the run stands at its start.")) +
      (not_made.isEmpty()
           ? QString()
           : ' ' + tr("This was not made, and may have ended it: %1.").arg(not_made.join(", "))));
  box->setInformativeText(cause_in(report));
  box->setDetailedText(report);
  box->open();
}

// What the engine sends

void MainWindow::watch() {
  Json what = Json::array();
  const auto shows = [this](const QDockWidget* dock) { return seen_.contains(dock); };
  const bool is_behavior =
      !authoring_->selection().isEmpty() && authoring_->selection().front().contains("/behavior[");
  if (shows(docks_.coordination) || is_behavior) what.push_back("decisions");
  if (shows(docks_.sensors)) what.push_back("sensors");
  if (shows(docks_.graph) && filled_.contains(docks_.graph)) what.push_back("graphs");
  if (shows(docks_.plots) || !plots_->choice().isEmpty()) what.push_back("measures");
  if (shows(docks_.vision) && filled_.contains(docks_.vision)) what.push_back("cameras");
  const QStringList plotted = plots_->choice();
  const auto is_fuzzy = [](const QString& name) {
    return name.contains("/inputs/") || name.contains("/outputs/");
  };
  if (filled_.contains(docks_.fuzzy) &&
      (shows(docks_.fuzzy) || std::any_of(plotted.begin(), plotted.end(), is_fuzzy))) {
    what.push_back("fuzzy");
  }
  ask_for_fillings(what);
  what.push_back("stuck");
  if (scene_->stage().has_fields()) what.push_back("fields");
  if (scene_->stage().has_actuators()) what.push_back("lights");
  Json robots = Json::array();  // none: all
  if (!shows(docks_.vision) &&
      place_of(workbench_.tree(), "robot[" + watched_robot_ + ']').element) {
    robots.push_back(watched_robot_.toStdString());
  }
  const std::vector<Stage::Body>& bodies = scene_->stage().bodies();
  const bool are_few = std::count_if(bodies.begin(), bodies.end(),
                                     std::mem_fn(&Stage::Body::is_robot)) <= kFewRobots;
  plottable_ = are_few ? QStringList() : plots_->chosen_robots() + QStringList{watched_robot_};
  request_past();
  const Json order{{"do", "watch"}, {"what", what}, {"robots", robots}};
  const QString asked =
      QString::fromStdString(order.dump()) + QString::number(workbench_.engine().generation());
  if (asked != watched_ && workbench_.tree().is_object()) {
    watched_ = asked;
    workbench_.ask(order, {});
  }
}

void MainWindow::request_past() {
  const bool plots = seen_.contains(docks_.plots) || !plots_->choice().isEmpty();
  const bool looks_back = time_line_->is_in_the_past();
  const bool graph = seen_.contains(docks_.graph) && looks_back;
  past_->request_paths(scene_->overlays().trails);
  if (!plots && !graph && !seen_.contains(docks_.coordination)) {
    past_->request_no_numbers();
    return;
  }
  QStringList numbers = plots ? plots_->chosen() : QStringList();
  if (seen_.contains(docks_.coordination)) numbers += coordination_->numbers(looks_back);
  if (graph) numbers += graph_->numbers();
  numbers.removeDuplicates();
  past_->request_numbers(numbers, plottable_);
}

void MainWindow::show_values(const Json& state) {
  for (WorldTree* each : findChildren<WorldTree*>()) {
    if (each->isVisible()) each->show_weights(state);
  }
  properties_->show_state(state);
}

void MainWindow::show_looked_back() {
  const auto time_s =
      time_line_->is_in_the_past() ? std::optional(workbench_.time_s()) : std::nullopt;
  coordination_->look_back(time_s);
  graph_->look_back(time_s);
  plots_->look_back(time_s);
}

void MainWindow::show_instant() {
  const Instant* const then = time_line_->instant();
  coordination_->set_look(then);
  sensors_->look_back(then);
  fuzzy_->look_back(then);
  vision_->look_back(then);
  if (then) {
    show_values(then->state_of(watched_robot_));
  } else {
    properties_->form().clear_live();
    show_pose();
  }
}

void MainWindow::watch_robot(const QString& id) {
  if (id != watched_robot_) {
    watched_robot_ = id;
    docks_.coordination->setWindowTitle(id.isEmpty() ? tr("Coordination")
                                                     : tr("Coordination of %1").arg(id));
    coordination_->set_robot(id);
    fuzzy_->set_robot(id);
    sensors_->set_robot(id);
    graph_->set_robot(id);
    time_line_->set_robots({id});
    show_looked_back();
    show_instant();
  }
}

}  // namespace elsie::desktop
