#include "elsie/simulation/run.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <utility>
#include <vector>

#include "elsie/simulation/simulation.h"

#include "simulation_impl.h"

namespace elsie::simulation {

class Run::Impl {
 public:
  Impl(Simulation& simulation, std::span<Observer* const> observers,
       std::span<const TimedEdit> edits, std::function<void(Simulation&)> before_control)
      : simulation_(simulation),
        observers_(observers.begin(), observers.end()),
        given_(edits.begin(), edits.end()),
        before_control_(std::move(before_control)) {
    std::vector<UnmadeEdits> unmade;
    schedule_ = of().checked(with_own(simulation.world(), given_), given_, unmade);
    for (UnmadeEdits& each : unmade) {
      of().said_.notes.push_back({"", "changes", std::move(each.sentence)});
    }
    of().given_ = given_;
    scheduled_ = of().new_schedules_;
    guarded([&] {
      make_due_edits();
      of().obey_rules();
      for (Observer* observer : observers_) {
        observer->started(simulation_);
        ++watching_;
      }
      heard_of_ = of().renewals_;
    });
  }

  bool step() {
    if (failure_) std::rethrow_exception(failure_);
    if (simulation_.outcome() != Outcome::running) return false;
    guarded([&] {
      make_due_edits();
      if (before_control_ && of().is_control_instant()) before_control_(simulation_);
      of().obey_rules();
      let_observers_know();
      simulation_.step();
      for (Observer* observer : observers_) {
        observer->stepped(simulation_);
      }
      const auto& limit = simulation_.world().limits.wall_time;
      if (limit && wall_s() >= *limit && simulation_.outcome() == Outcome::running) {
        of().judgement_ = {Outcome::time_limit, "the limit of time on the clock was met"};
      }
    });
    return true;
  }

  RunResult end() {
    finish();
    if (failure_) std::rethrow_exception(failure_);
    return simulation_.result();
  }

  /// Keeps the first exception.
  void finish() {
    if (std::exchange(has_ended_, true)) return;
    of().wall_s_ = wall_s();
    for (std::size_t i = 0; i < watching_; ++i) {
      try {
        observers_[i]->ended(simulation_);
      } catch (...) {
        failure_ = failure_ ? failure_ : std::current_exception();
      }
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  Simulation::Impl& of() const { return *simulation_.impl_; }
  double wall_s() const {
    return std::chrono::duration<double>(Clock::now() - started_at_).count();
  }

  template <class Work>
  void guarded(const Work& work) {
    try {
      work();
    } catch (...) {
      failure_ = std::current_exception();
      finish();
      throw;
    }
  }

  void let_observers_know() {
    for (std::size_t i = 0; i < watching_; ++i) {
      if (of().renewals_ != heard_of_) observers_[i]->replaced(simulation_);
    }
    heard_of_ = of().renewals_;
  }

  void make_due_edits() {
    if (of().new_schedules_ != scheduled_) {  // World::edits changed
      std::vector<UnmadeEdits> known;         // reported already
      schedule_ =
          of().checked(still_to_come(simulation_.world(), given_, made_until_s_), given_, known);
      next_ = 0;
      scheduled_ = of().new_schedules_;
    }
    made_until_s_ = simulation_.time_s();
    for (; next_ < schedule_.size() &&
           schedule_[next_].are_due(made_until_s_, simulation_.world().physics.step);
         ++next_) {
      of().edit(schedule_[next_]);
      let_observers_know();
    }
  }

  Simulation& simulation_;
  std::vector<Observer*> observers_;
  std::vector<TimedEdit> given_;
  std::function<void(Simulation&)> before_control_;
  std::vector<DueEdits> schedule_;
  std::size_t next_ = 0;  // of the schedule
  std::uint64_t scheduled_ = 0;
  double made_until_s_ = 0.0;
  std::size_t watching_ = 0;  // observers whose started() was called; ended() follows
  std::uint64_t heard_of_ = 0;
  bool has_ended_ = false;
  std::exception_ptr failure_;
  Clock::time_point started_at_ = Clock::now();
};

Run::Run(Simulation& simulation, std::span<Observer* const> observers,
         std::span<const TimedEdit> edits, std::function<void(Simulation&)> before_control)
    : impl_(std::make_unique<Impl>(simulation, observers, edits, std::move(before_control))) {}
Run::~Run() { impl_->finish(); }

bool Run::step() { return impl_->step(); }
RunResult Run::end() { return impl_->end(); }

}  // namespace elsie::simulation
