#include <QFileInfo>
#include <QLabel>
#include <QMenu>
#include <algorithm>

#include "control_bar.h"
#include "main_window.h"
#include "paint/warning_label.h"
#include "recorded_world.h"
#include "scene/scene_view.h"

// Recorded runs: opening and playing them, and comparing them with the run made here.

namespace elsie::desktop {

void MainWindow::open_database(const QString& file) {
  say(tr("Reading '%1'...").arg(file));
  runs_->list_runs(file, [this, file](const std::vector<StoredRun>& runs) {
    ask_for_run(runs, this, [this, file](const StoredRun& run) { read_run(file, run); });
  });
}

void MainWindow::read_run(const QString& file, const StoredRun& run) {
  say(tr("Reading '%1'...").arg(file));
  runs_->read_world(file, run.number, [this, file, run](RecordedWorld world) {
    QString why;
    if (!may_leave()) {
      return;
    }
    if (!workbench_.open(world.file, why, world.seed, true)) {
      warn(this, tr("The run cannot be opened"), why);
      return;
    }
    show_opened(file);
    const QString name = QFileInfo(file).fileName();
    if (run.number > 0) {
      const bool is_cut = world.end.is_cut || run.end.is_cut;
      world.end = run.end;
      world.end.is_cut = is_cut;
      show_recording(
          {file, run.number, tr("run %1 of %2").arg(run.number).arg(name), world, {}, {}});
      time_line_->expect({}, run.end.time_s);
      return;
    }
    show_recording(
        {file, 0, world.is_whole ? name : tr("%1 (not whole)").arg(name), world, {}, {}});
    if (!world.is_whole) {
      say(tr("'%1' is not whole: its writing was cut off. It is played as far as it goes.")
              .arg(name));
    }
    runs_->read_events(file, [this](const RecordedEvents& recorded) {
      time_line_->expect(recorded.events, recorded.end_s);
      set_end_of_recording(recorded.end_s);
    });
  });
}

void MainWindow::show_recording(Recorded recorded) {
  recorded.text = workbench_.text();
  recorded_ = std::make_unique<Recorded>(std::move(recorded));
  set_end_of_recording(recorded_->world.end.time_s);
  show_state();
}

void MainWindow::set_end_of_recording(double time_s) {
  if (!recorded_ || time_s <= 0.0) {
    return;
  }
  recorded_->world.end.time_s = time_s;
  if (!recorded_->world.end.is_cut) {
    return;  // the run ends there without a halt
  }
  workbench_.set_halt(time_s);
  if (workbench_.run_state() == Workbench::Run::running) {
    workbench_.run();  // up to the halt
  }
}

const Recorded* MainWindow::recorded() const {
  return recorded_ && workbench_.is_borrowed() && workbench_.text() == recorded_->text &&
                 workbench_.seed() == recorded_->world.seed
             ? recorded_.get()
             : nullptr;
}

// Compares only at the same step: a run pauses between two decisions, and a recording may end
// within one.
void MainWindow::compare_with_recording(const Json& end) {
  const RecordedEnd& wanted = recorded() ? recorded_->world.end : RecordedEnd();
  if (wanted.state_hash.isEmpty() || end.value("steps", qint64{-1}) != wanted.steps) {
    return;
  }
  const bool is_same = text_of(end, "state_hash") == wanted.state_hash;
  recorded_->verdict = is_same ? tr("as recorded") : tr("not as recorded");
  if (!is_same) {
    warn(this, tr("Not the recorded run"),
         tr("This run ended differently from the recorded one: state hash %1, recorded %2. "
            "Another version of Elsie, other plugins or other files of the world made the "
            "recording.")
             .arg(text_of(end, "state_hash"), wanted.state_hash));
  }
  show_state();
}

/// Lists the events from the shown time on, and the last ones before it.
void MainWindow::list_events(QMenu* menu) {
  constexpr std::size_t kMost = 30;
  constexpr std::size_t kMostBefore = 10;
  menu->clear();
  const TimeLine::Marks events = time_line_->events();
  const auto ahead = static_cast<std::size_t>(
      std::count_if(events.begin(), events.end(),
                    [this](const auto& each) { return each.first <= workbench_.time_s(); }));
  const std::size_t from = ahead > kMostBefore ? ahead - kMostBefore : 0;
  for (std::size_t i = from; i < std::min(events.size(), from + kMost); ++i) {
    const auto& [time_s, what] = events[i];
    connect(menu->addAction(tr("%1 s: %2").arg(time_s, 0, 'f', 2).arg(what)), &QAction::triggered,
            this, [this, at_s = time_s] { time_line_->go_to(at_s); });
  }
  if (events.empty()) {
    menu->addAction(tr("No events yet"))->setEnabled(false);
  }
}

// Start, pause and the seed

/// Continues the run from its present time; while the past is shown, a finished or recorded run is
/// played from the shown time. A finished run starts again.
void MainWindow::run_or_pause() {
  const bool is_over = workbench_.run_state() == Workbench::Run::ended || workbench_.is_at_halt();
  if (time_line_->is_playing()) {
    time_line_->stop_playing();
  } else if (workbench_.run_state() == Workbench::Run::running) {
    workbench_.pause();
  } else if (time_line_->is_in_the_past() && (is_over || recorded())) {
    time_line_->play();
  } else {
    if (workbench_.run_state() == Workbench::Run::ended) workbench_.reset(workbench_.seed());
    workbench_.run();
  }
}

void MainWindow::show_past() {
  control_bar_->show_past(time_line_->is_playing()       ? ControlBar::Past::plays
                          : time_line_->is_in_the_past() ? ControlBar::Past::may_play
                                                         : ControlBar::Past::none);
  show_looked_back();
  request_past();
  show_state();
}

/// Asks first if a run is under way, because that run would be lost.
void MainWindow::begin_anew(quint64 seed) {
  const bool is_under_way = workbench_.run_state() == Workbench::Run::running ||
                            workbench_.run_state() == Workbench::Run::paused;
  if (is_seed_asked_) {
    return;  // the question takes the focus from the field, which enters the seed again
  }
  is_seed_asked_ = true;
  const bool may_begin =
      !is_under_way ||
      is_agreed("new_seed", tr("A new seed"),
                tr("The run is at %1 s. A new seed starts it again, and this run is lost. Start "
                   "again with seed %2?")
                    .arg(workbench_.latest_s(), 0, 'f', 2)
                    .arg(seed));
  is_seed_asked_ = false;
  if (may_begin) {
    workbench_.reset(seed);
  } else {
    control_bar_->show_seed();
  }
}

}  // namespace elsie::desktop
