#include "end_again.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string_view>

#include <sys/syscall.h>
#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/plugin/call.h"
#include "elsie/simulation/simulation.h"

#include "command.h"
#include "supervised.h"

namespace elsie::program {

using batch::RunRecord;
using batch::RunState;
using plugin::CallFacts;

namespace {

constexpr double kGrace = 2.0;  // s, for the current step
constexpr int kLimitSignal = SIGALRM;

// A signal handler can only reach a global.
std::atomic<EndAgain*> the_one{nullptr};

void say(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = write(out_descriptor(), text.data(), text.size());
    if (count < 0 && errno != EINTR) {
      return;
    }
    text.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
}

void say(std::uint64_t number) noexcept {
  char digits[20];
  say({digits, static_cast<std::size_t>(std::to_chars(digits, digits + sizeof(digits), number).ptr -
                                        digits)});
}

void say_place(const CallFacts& at, const batch::Moment& now) noexcept {
  if (at.plugin) {
    say("plugin '");
    say(*at.plugin);
    say("'");
    if (at.id && *at.id != *at.plugin) {
      say(" (id '");
      say(*at.id);
      say("')");
    }
    if (at.robot) {
      say(" of robot '");
      say(*at.robot);
      say("'");
    }
  } else {
    say("no plugin");
  }
  say(" in step ");
  say(now.step);
  say(" (at ");
  say(base::NumberText(std::round(1e6 * now.time_s) / 1e6).view());
  say(" s)");
}

batch::Moment moment_of(const CallFacts& at, const batch::Moment& otherwise) noexcept {
  return at.step != CallFacts::kNoStep ? batch::Moment{at.step, at.time_s} : otherwise;
}

bool is_same(const std::optional<std::string>& before, const std::string* now) noexcept {
  return now ? before && *before == *now : !before;
}

/// " in step 50 (at 0.5 s)", as in the message, which alone has the time.
std::string step_of(const RunRecord& record) {
  if (!record.step) return "";
  const std::string words = " in step " + std::to_string(*record.step);
  const std::size_t at = record.message.find(words + " (");
  const std::size_t end = at == std::string::npos ? at : record.message.find(')', at);
  return end == std::string::npos ? words : record.message.substr(at, end + 1 - at);
}

/// "plugin 'x' of robot 'r1' in step 50 (at 0.5 s)".
std::string place_of(const RunRecord& record) {
  return (record.plugin ? "plugin '" + *record.plugin + "'" : "no plugin") +
         (record.robot ? " of robot '" + *record.robot + "'" : "") + step_of(record);
}

/// The end of the sentence after "not the same" and the current state.
std::string before_text(const RunRecord& record) {
  return record.state == RunState::hang
             ? ", before in " + place_of(record)
             : ", before " + std::string(to_string(record.state)) + ": " + record.message;
}

}  // namespace

EndAgain::EndAgain(const RunRecord& before, double wall_limit_s)
    : before_(before),
      wall_limit_s_(wall_limit_s),
      same_("the same: " +
            (before.state == RunState::hang ? "hangs in " + place_of(before) : before.message) +
            "\n"),
      not_same_(before_text(before) + "\n") {
  the_one = this;
  if (wall_limit_s_ <= 0.0) {
    return;
  }
  struct sigaction action {};
  action.sa_handler = limit_is_met;
  action.sa_flags = SA_ONSTACK | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(kLimitSignal, &action, nullptr);
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = kLimitSignal;
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
  if (timer_create(CLOCK_MONOTONIC, &event, &timer_) != 0) {
    retire();
    throw std::runtime_error("cannot create the timer for the wall limit of the run");
  }
}

EndAgain::~EndAgain() {
  if (wall_limit_s_ > 0.0) {
    timer_delete(timer_);
    std::signal(kLimitSignal, SIG_IGN);  // one may be pending
  }
  the_one = nullptr;
  retire();
}

void EndAgain::set_timer(double seconds) const noexcept {
  if (wall_limit_s_ > 0.0) {
    itimerspec times{};
    times.it_value.tv_sec = static_cast<time_t>(seconds);
    times.it_value.tv_nsec = static_cast<long>(1e9 * (seconds - std::floor(seconds)));
    timer_settime(timer_, 0, &times, nullptr);
  }
}

void EndAgain::start_clock() const noexcept { set_timer(wall_limit_s_); }

void EndAgain::started(const simulation::Simulation& simulation) {
  step_ = simulation.steps();
  time_s_ = simulation.time_s();
}

void EndAgain::stepped(const simulation::Simulation& simulation) {
  last_s_ = time_s_;
  started(simulation);
  if (is_late_ && simulation.outcome() == simulation::Outcome::running) {
    throw WallLimitMet();
  }
}

void EndAgain::ended(const simulation::Simulation&) { set_timer(0.0); }

std::string EndAgain::slow() const {
  const std::uint64_t step = step_ - 1;
  const std::string now = "after " + base::number_text(wall_limit_s_, 6) +
                          " s on the clock it was in " + base::step_text(step, last_s_) +
                          " and went on";
  if (before_.state != RunState::hang) {
    return "the run has not ended: " + now + not_same_;
  }
  if (before_.step && step < *before_.step) {
    return "the run did not get as far as before: " + now + not_same_ +
           "--wall-limit gives it more time\n";
  }
  return "the run is slow, and does not hang: " + now + not_same_ +
         "--wall-limit gives it more time\n";
}

bool EndAgain::is_same_place() const noexcept {
  const CallFacts now = process::facts_at_work();
  return before_.step == moment_of(now, {step_, 0.0}).step && is_same(before_.plugin, now.plugin) &&
         is_same(before_.robot, now.robot);
}

void EndAgain::limit_is_met(int) {
  const int error = errno;
  EndAgain* const self = the_one;
  if (!self) {
    return;
  }
  const bool same = self->before_.state == RunState::hang && self->is_same_place();
  if (!same && !self->is_late_) {
    self->is_late_ = true;
    self->set_timer(kGrace);
    errno = error;
    return;
  }
  self->is_told_ = true;
  if (same) {
    say(self->same_);
  } else {
    say("not the same: hangs in ");
    const CallFacts now = process::facts_at_work();
    say_place(now, moment_of(now, {self->step_, self->time_s_}));
    say(self->not_same_);
  }
  process::end_process("did not return before the wall limit of the run",
                       "the run did not end before its wall limit", same ? kSuccess : kGoalMissed);
}

bool EndAgain::write_now() noexcept {
  if (is_told_) {
    return false;
  }
  const int signal = process::signal_of_crash();
  const char* const name = signal != 0 ? sigabbrev_np(signal) : nullptr;
  const bool same_signal = name ? before_.signal && before_.signal->starts_with("SIG") &&
                                      before_.signal->compare(3, std::string::npos, name) == 0
                                : !before_.signal;
  if (before_.state == RunState::crash && same_signal && is_same_place()) {
    say(same_);
  } else if (name) {  // otherwise a user may be interrupting it
    say("not the same");
    say(not_same_);
  }
  return false;
}

}  // namespace elsie::program
