#include "elsie/live/live_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include "elsie/recording/run_messages.h"
#include "elsie/simulation/run.h"
#include "elsie/simulation/simulation.h"

#include "hub.h"
#include "live_sink.h"
#include "server.h"

namespace elsie::live {
namespace {

using simulation::Run;
using simulation::Simulation;
using WallClock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr Seconds kBetweenPictures{1.0 / 30.0};
constexpr Seconds kNap{0.05};      // short, so that an interrupt is noticed soon
constexpr Seconds kMostLate{0.1};  // a run that was slower than its pace does not make up for it

std::uint64_t nanoseconds(double time_s) {
  return static_cast<std::uint64_t>(std::llround(time_s * 1e9));
}

recording::RecorderOptions recorded(const Options& options) {
  return {.images = true,
          .with_times = options.with_times,
          .robots = options.robots,
          .program = options.program,
          .warn = [warn = options.warn](const std::string& text) {
            warn("the live view lacks " + text);
          }};
}

ServerFacts facts(const Options& options) {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return {.program = options.program, .session = std::to_string(now.count())};
}

}  // namespace

/// Two simulations, of which one is shown: the run itself, and the past, which is made again when a
/// viewer goes back. The past never passes the run; where it reaches it, the run is shown again.
class LiveRun::Impl : private simulation::Observer {
 public:
  Impl(const Address& address, Options options)
      : options_(std::move(options)), server_(address), speed_(options_.speed) {}

  const Address& address() const { return server_.address(); }

  void open(const Simulation& simulation, Again again) {
    again_ = std::move(again);
    hub_.set_end(nanoseconds(simulation.time_limit_s()));
    server_.start(hub_, options_.origins);
  }

  void start(const Simulation& run) {
    messages_.begin(run);
    said_ = &run;
    step_s_ = run.world().physics.step;
    tell(run);
    restart_clock(run);
  }

  void step(const Simulation& run) {
    show(run);
    if (target_s_) {
      if (has_reached(run, *target_s_)) {
        arrive(run);
      } else if (!run.decided() || !hub_.has_orders()) {
        return;
      }
    }
    steer(run);
  }

  void replace(const Simulation& run) { messages_.replace(run); }

  void end(const Simulation& run) {
    if (const std::string why = recording::why_stopped(); !why.empty()) hub_.say(Level::error, why);
    has_ended_ = true;
    hub_.set_end(nanoseconds(run.time_s()));
    if (target_s_) return arrive(run);
    if (said_ != &run) turn_to(run, run_decided_s_);
    is_past_shown_ = false;
    // The last decision may be half of a step that a plugin did not end.
    messages_.end(run, run.outcome() != simulation::Outcome::running, period_s());
    hub_.say_time(nanoseconds(run.time_s()));
    tell(run);
  }

  void linger(const Simulation& run) { steer(run); }

  Counts counts() const { return hub_.counts(); }

 private:
  /// Of the past, while it is shown.
  void replaced(const Simulation& past) override {
    if (is_past_shown_) messages_.replace(past);
  }

  /// Holds the run until its next step is due, and shows the past meanwhile if that is asked for.
  void steer(const Simulation& run) {
    while (!options_.is_interrupted()) {
      if (run.decided() || has_ended_) obey(run);
      if (past_target_s_) {
        go_to_past(run);
        continue;
      }
      const Simulation& shown = is_past_shown_ ? *past_ : run;
      if (hub_.has_new() && !target_s_) sink_.repeat([&] { messages_.repeat(shown, period_s()); });
      const bool is_run = !is_past_shown_;
      if (is_run && !has_ended_ && target_s_) return;
      // Orders are obeyed after a decision. It comes at once, however low the speed is.
      if (is_run && !has_ended_ && !run.decided() && hub_.has_orders()) return;
      const bool can_step = !is_run || !has_ended_;
      const Seconds early = can_step && is_playing_ ? until_due(shown) : kNap;
      if (early > Seconds::zero()) {
        hub_.wait(std::min(early, kNap));
        continue;
      }
      if (is_run) return;
      step_past(run);
    }
  }

  void obey(const Simulation& run) {
    std::vector<Order> orders = hub_.take_orders();
    if (orders.empty()) return;
    std::optional<double> seek_s;
    for (const Order& order : orders) {
      is_playing_ = order.steer.plays.value_or(is_playing_);
      speed_ = order.steer.speed.value_or(speed_);
      if (order.steer.seek_ns) seek_s = static_cast<double>(*order.steer.seek_ns) * 1e-9;
    }
    answers_.insert(answers_.end(), orders.begin(), orders.end());
    if (seek_s) return seek(run, *seek_s);
    if (target_s_ || past_target_s_) return;  // the answer follows when that is reached
    const Simulation& shown = is_past_shown_ ? *past_ : run;
    if (!is_playing_) take_picture(shown);
    restart_clock(shown);
    tell(shown);
  }

  void seek(const Simulation& run, double time_s) {
    const bool goes_back = time_s < run.time_s() - 0.5 * step_s_;
    if (goes_back && !again_.make) {
      hub_.say(Level::warning, again_.reason);
      return answer(is_past_shown_ ? *past_ : run, false);
    }
    if (said_ == &run) run_decided_s_ = messages_.decided_s();
    is_past_shown_ = false;
    target_s_.reset();
    past_target_s_.reset();
    if (goes_back) {
      past_target_s_ = time_s;
      sink_.mute(false);
      return hub_.say({Phase::seeking, nanoseconds(time_s), speed_}, false, {});
    }
    target_s_ = std::min(time_s, run.time_limit_s());
    sink_.mute(true);
    if (said_ != &run) turn_to(run, run_decided_s_);
    if (has_ended_ || has_reached(run, *target_s_)) return arrive(run);
    tell(run);
  }

  /// The run has reached the time that a viewer wanted.
  void arrive(const Simulation& run) {
    target_s_.reset();
    sink_.mute(false);
    turn_to(run, messages_.decided_s());
    answer(run, true);
  }

  /// Makes the run again, up to a time before its present one, or until there are new orders: a
  /// viewer whose handle is dragged asks for many times, one after the other.
  void go_to_past(const Simulation& run) {
    try {
      if (!past_) past_ = again_.make();
      if (!past_run_ || *past_target_s_ < past_->time_s() - 0.5 * step_s_) begin_past();
      while (past_->steps() < run.steps() && !has_reached(*past_, *past_target_s_) &&
             past_run_->step()) {
        if (options_.is_interrupted() || hub_.has_orders()) return;
      }
      past_target_s_.reset();
      is_past_shown_ = true;
      turn_to(*past_, past_->steps() > 0 ? past_->step_began_s() : 0.0);
      answer(*past_, true);
    } catch (const std::exception& error) {
      leave_past(run, std::string("the run cannot be made again: ") + error.what());
    }
  }

  void begin_past() {
    past_run_.reset();
    past_->reset();
    simulation::Observer* const watchers[] = {this};
    past_run_.emplace(*past_, watchers, again_.edits);
  }

  void step_past(const Simulation& run) {
    try {
      if (past_->steps() < run.steps() && past_run_->step()) return show(*past_);
      leave_past(run, past_->state_hash() == run.state_hash()
                          ? ""
                          : "the past that was shown is not that of this run: something in it "
                            "depends on more than the world and the seed");
    } catch (const std::exception& error) {
      leave_past(run, std::string("the past cannot be shown further: ") + error.what());
    }
  }

  /// Shows the run again. `trouble`: a sentence for the viewers; empty: none.
  void leave_past(const Simulation& run, const std::string& trouble) {
    if (!trouble.empty()) {
      hub_.say(Level::error, trouble);
      options_.warn(trouble);
      past_run_.reset();
    }
    past_target_s_.reset();
    const bool jumps = !is_past_shown_ || past_->steps() != run.steps();
    is_past_shown_ = false;
    jumps || !trouble.empty() ? turn_to(run, run_decided_s_) : go_on_with(run);
    answer(run, jumps);
  }

  /// Shows the run where the past has reached it: what the past has said is not said again.
  void go_on_with(const Simulation& run) {
    said_ = &run;
    sink_.look();
    messages_.follow(run, run_decided_s_);
    if (!has_ended_) return take_picture(run);
    messages_.end(run, run.outcome() != simulation::Outcome::running, period_s());
    hub_.say_time(nanoseconds(run.time_s()));
  }

  /// Says the whole state of a simulation, and from now on what its steps change.
  void turn_to(const Simulation& simulation, double decided_s) {
    said_ = &simulation;
    sink_.begin_anew();
    messages_.resume(simulation, decided_s, period_s());
    pictured_ = WallClock::now();
    if (!target_s_) hub_.say_time(nanoseconds(simulation.time_s()));
  }

  /// Ends a change of what is shown.
  void answer(const Simulation& shown, bool did_seek) {
    restart_clock(shown);
    hub_.say(playback(shown), did_seek, std::exchange(answers_, {}));
  }
  void tell(const Simulation& shown) {
    if (target_s_) {
      hub_.say({Phase::seeking, nanoseconds(*target_s_), speed_}, false, {});
    } else {
      hub_.say(playback(shown), false, std::exchange(answers_, {}));
    }
  }
  Playback playback(const Simulation& shown) const {
    const bool is_at_end = has_ended_ && !is_past_shown_;
    return {is_at_end     ? Phase::ended
            : is_playing_ ? Phase::playing
                          : Phase::paused,
            nanoseconds(shown.time_s()), speed_};
  }

  /// Says what a step changed.
  void show(const Simulation& shown) {
    sink_.look();
    messages_.step(shown);
    if (!target_s_ && WallClock::now() - pictured_ >= kBetweenPictures) take_picture(shown);
  }
  void take_picture(const Simulation& shown) {
    pictured_ = WallClock::now();
    messages_.sample(shown, shown.steps() > 0, period_s());
    hub_.say_time(nanoseconds(shown.time_s()));
  }
  /// Simulated time from one picture to the next; twice that, because pictures are late at times.
  double period_s() const {
    constexpr double kMost = 1e9;  // s: its nanoseconds fit, whatever the speed
    return std::min(std::max(2.0 * speed_ * kBetweenPictures.count(), 2 * step_s_), kMost);
  }

  /// Whether the simulation is at this time, after a decision: only then all of it is of one time.
  bool has_reached(const Simulation& simulation, double time_s) const {
    return simulation.time_s() > time_s - 0.5 * step_s_ &&
           (simulation.decided() || simulation.steps() == 0);
  }

  void restart_clock(const Simulation& shown) {
    clock_ = WallClock::now();
    clock_s_ = shown.time_s();
  }
  Seconds until_due(const Simulation& shown) {
    const Seconds early =
        Seconds((shown.time_s() - clock_s_) / speed_) - (WallClock::now() - clock_);
    if (early < -kMostLate) restart_clock(shown);
    return early;
  }

  const Options options_;
  Again again_;
  Hub hub_{facts(options_)};
  LiveSink sink_{hub_};
  recording::RunMessages messages_{sink_, recorded(options_)};
  Server server_;

  bool is_playing_ = true;
  double speed_;
  // The run, or the past, goes there as fast as it can.
  std::optional<double> target_s_, past_target_s_;
  bool has_ended_ = false;
  std::vector<Order> answers_;  // orders that are obeyed, and not answered yet

  std::unique_ptr<Simulation> past_;
  std::optional<Run> past_run_;
  bool is_past_shown_ = false;
  const Simulation* said_ = nullptr;  // that the messages are about
  double run_decided_s_ = 0.0;        // of the run, while the messages are about the past

  double step_s_ = 0.0;
  WallClock::time_point pictured_{};
  WallClock::time_point clock_ = WallClock::now();  // the pace is counted from here,
  double clock_s_ = 0.0;                            // and from this simulated time
};

LiveRun::LiveRun(const Address& address, Options options)
    : impl_(std::make_unique<Impl>(address, std::move(options))) {}
LiveRun::~LiveRun() = default;

const Address& LiveRun::address() const { return impl_->address(); }
void LiveRun::open(const Simulation& simulation, Again again) {
  impl_->open(simulation, std::move(again));
}
void LiveRun::started(const Simulation& simulation) { impl_->start(simulation); }
void LiveRun::stepped(const Simulation& simulation) { impl_->step(simulation); }
void LiveRun::replaced(const Simulation& simulation) { impl_->replace(simulation); }
void LiveRun::ended(const Simulation& simulation) { impl_->end(simulation); }
void LiveRun::linger(const Simulation& simulation) { impl_->linger(simulation); }
Counts LiveRun::counts() const { return impl_->counts(); }

}  // namespace elsie::live
