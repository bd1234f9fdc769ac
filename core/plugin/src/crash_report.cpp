#include "elsie/plugin/crash_report.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "elsie/plugin/call.h"

#include "stack_trace.h"

namespace elsie::plugin {

bool write_all_now() noexcept;

namespace {

// All that a handler of signals can reach are globals, and so is what is told to all handlers.
std::array<std::atomic<EmergencyWriter*>, 512> writers;
std::atomic<int> status_of_crash{0};
std::atomic<pid_t> reporter{0};  // the thread that has come to grief first
std::atomic<bool> is_cleaning{false};
std::atomic<int> crash_signal{0};

constexpr std::size_t kStackSize = 256 * 1024;
constexpr int kWatchdogSignal = SIGVTALRM;
std::atomic<std::int64_t> watchdog_limit_ns{0};
std::atomic<int> watchdog_status{0};

struct Crash {
  int signal;
  const char* what;
};
constexpr Crash kCrashes[] = {
    {SIGSEGV, "ended the program with a segmentation fault (SIGSEGV)"},
    {SIGBUS, "ended the program with a bus error (SIGBUS)"},
    {SIGILL, "ended the program with an illegal instruction (SIGILL)"},
    {SIGFPE,
     "ended the program with an arithmetic error, such as a whole number divided by zero "
     "(SIGFPE)"},
    {SIGABRT,
     "ended the program with an abort (SIGABRT), as an exception that nobody catches does"},
};

/// What ends a process as well, but is nobody's fault: it is only cleaned up after.
constexpr int kOtherEnds[] = {SIGPIPE, SIGQUIT, SIGXCPU, SIGXFSZ, SIGUSR1, SIGUSR2, SIGALRM};

pid_t this_thread() { return static_cast<pid_t>(syscall(SYS_gettid)); }

void write_number(std::uint64_t number) {
  char digits[20];
  std::size_t count = 0;
  do {
    digits[count++] = static_cast<char>('0' + number % 10);
    number /= 10;
  } while (number != 0);
  std::reverse(digits, digits + count);
  write_error({digits, count});
}

void write_quoted(const char* before, const char* text) {
  if (text) {
    write_error(before);
    write_error("'");
    write_error(text);
    write_error("'");
  }
}

/// Whether the thread is in a plugin's code, and not only in that which is about to call it.
bool is_plugin_at_work() {
  for (const Call* call = Call::innermost(); call; call = call->outer()) {
    if (call->facts().plugin || call->facts().library) {
      return true;
    }
  }
  return false;
}

void write_culprit(const CallFacts& facts) {
  if (facts.plugin) {
    write_quoted("plugin ", facts.plugin);
    if (facts.id && std::string_view(facts.id) != facts.plugin) {
      write_quoted(" (id ", facts.id);
      write_error(")");
    }
  } else {
    write_quoted("plugin library ", facts.library ? facts.library : "?");
  }
  write_quoted(" of robot ", facts.robot);
}

void write_when(const CallFacts& facts) {
  if (facts.step != CallFacts::kNoStep) {
    write_error(" in step ");
    write_number(facts.step);
  } else if (facts.doing) {
    write_error(", ");
    write_error(facts.doing);
  }
  if (facts.file && facts.line > 0) {
    write_error(" (");
    write_error(facts.file);
    write_error(":");
    write_number(static_cast<std::uint64_t>(facts.line));
    write_error(")");
  }
}

/// Whether a library is being loaded, and nothing says yet that it does not come to an end.
bool is_just_loading() {
  constexpr double kLong = 1.0;  // s
  const Call* const call = Call::innermost();
  const double since = call && call->facts().library ? call->own_time_s() : 0.0;
  return since > 0.0 && since < kLong && !facts_at_work().plugin;
}

/// Once, whatever comes of it.
void clean_up() {
  if (is_cleaning.exchange(true)) {
    return;
  }
  for (const auto& slot : writers) {
    if (EmergencyWriter* const writer = slot.load()) {
      writer->clean_up_now();
    }
  }
}

void write_culprit_and(const char* what) {
  write_error("elsie: ");
  if (is_plugin_at_work()) {
    const CallFacts facts = facts_at_work();
    write_culprit(facts);
    write_error(" ");
    write_error(what);
    write_when(facts);
    if (facts.plugin && facts.library) {
      write_error("; it is from ");
      write_error(facts.library);
    }
  } else {
    write_error("something outside of all plugins ");
    write_error(what);
  }
  write_error("\n");
}

void write_report(const char* what, const Fault& place) {
  write_culprit_and(what);
  // First what matters: a stack that was written over may be the end of the trace.
  if (write_all_now()) {
    write_error("what was recorded until then is kept\n");
  }
  write_error("the stack, from the inside out:\n");
  write_stack_trace(place);
  clean_up();
}

Fault place_of_fault(const void* context) {
#if defined(__x86_64__)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  return {reinterpret_cast<const void*>(registers[REG_RIP]),
          reinterpret_cast<const void* const*>(registers[REG_RSP]), nullptr};
#elif defined(__aarch64__)
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext;
  return {reinterpret_cast<const void*>(registers.pc), nullptr,
          reinterpret_cast<const void*>(registers.regs[30])};
#else
  static_cast<void>(context);
  return {};
#endif
}

/// Whether this thread is the first one that comes to grief. If it did so before, its report came
/// to grief too: false. The others' end here; the first one ends the process.
bool may_report() {
  pid_t none = 0;
  if (reporter.compare_exchange_strong(none, this_thread())) {
    return true;
  }
  while (reporter != this_thread()) {
    pause();
  }
  return false;
}

/// As it would have ended by itself.
[[noreturn]] void end_by(int signal) {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  raise(signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  _exit(128 + signal);
}

void crashed(int signal, siginfo_t*, void* context) {
  if (may_report()) {
    crash_signal = signal;
    const auto crash = std::find_if(std::begin(kCrashes), std::end(kCrashes),
                                    [&](const Crash& known) { return known.signal == signal; });
    write_report(crash->what, place_of_fault(context));
    if (is_plugin_at_work()) {
      _exit(status_of_crash);
    }
    end_by(signal);
  }
  // The report came to grief. Nothing that may be on the stack is looked at again.
  write_error("  (no more of it can be read)\n");
  clean_up();
  if (Call::innermost()) {
    _exit(status_of_crash);
  }
  end_by(signal);
}

void ended(int signal) {
  clean_up();
  end_by(signal);
}

void left_by_exit() {
  if (is_plugin_at_work() && may_report()) {
    write_report("ended the program by calling exit()", {});
    _exit(status_of_crash);
  }
}

void look_for_endless_call(int, siginfo_t*, void* context) {
  const Call* const call = Call::innermost();
  if (call && 1e9 * call->own_time_s() > static_cast<double>(watchdog_limit_ns.load()) &&
      may_report()) {
    write_report("did not return within its time budget and was stopped", place_of_fault(context));
    _exit(watchdog_status);
  }
}

void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

void report_crashes(int exit_status) {
  status_of_crash = exit_status;
  prepare_stack_trace();
  alignas(16) static char stack[kStackSize];
  static const int once = std::atexit(left_by_exit);
  static_cast<void>(once);
  stack_t second{};
  second.ss_sp = stack;
  second.ss_size = kStackSize;
  sigaltstack(&second, nullptr);
  for (const Crash& crash : kCrashes) {
    // Not blocked while it is handled: a fault in the handler would end the process on the spot.
    handle(crash.signal, crashed, SA_ONSTACK | SA_NODEFER);
  }
  for (const int signal : kOtherEnds) {
    struct sigaction action {};
    if (sigaction(signal, nullptr, &action) == 0 && !(action.sa_flags & SA_SIGINFO) &&
        action.sa_handler == SIG_DFL) {
      action = {};
      action.sa_handler = ended;
      sigemptyset(&action.sa_mask);
      sigaction(signal, &action, nullptr);
    }
  }
}

void end_process(const char* what, const char* else_say, int exit_status, Stack stack) {
  // Outside of plugins a recorder may be in the middle of a line: what it holds is left alone.
  if (stack == Stack::left_out && is_just_loading() && may_report()) {
    write_error("elsie: interrupted while plugins were loaded\n");
  } else if (may_report() && is_plugin_at_work()) {
    stack == Stack::shown ? write_report(what, {}) : write_culprit_and(what);
  } else if (!is_plugin_at_work()) {
    write_error("elsie: ");
    write_error(else_say);
    write_error("\n");
  }
  clean_up();
  _exit(exit_status);
}

Watchdog::Watchdog(double limit_s, int exit_status) {
  prepare_stack_trace();
  watchdog_limit_ns = std::llround(1e9 * limit_s);
  watchdog_status = exit_status;
  handle(kWatchdogSignal, look_for_endless_call, SA_ONSTACK | SA_RESTART);
  sigevent event{};
  event.sigev_notify = SIGEV_THREAD_ID;
  event.sigev_signo = kWatchdogSignal;
  event._sigev_un._tid = this_thread();
  timer_t timer{};
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0) {
    throw std::runtime_error("no timer is to be had that would stop plugins which do not return");
  }
  timer_ = timer;
  // Often enough to come soon after the limit, and not more often.
  const std::int64_t period_ns =
      std::clamp<std::int64_t>(watchdog_limit_ns / 4, 1'000'000, 250'000'000);
  itimerspec times{};
  times.it_interval = {static_cast<time_t>(period_ns / 1'000'000'000),
                       static_cast<long>(period_ns % 1'000'000'000)};
  times.it_value = times.it_interval;
  timer_settime(timer, 0, &times, nullptr);
}

Watchdog::~Watchdog() {
  timer_delete(timer_);
  std::signal(kWatchdogSignal, SIG_IGN);  // one may be on its way
}

CallFacts facts_at_work() noexcept {
  CallFacts all;
  for (const Call* call = Call::innermost(); call; call = call->outer()) {
    const CallFacts& facts = call->facts();
    // Of the library only what belongs to the plugin.
    const bool other_plugin =
        all.plugin && facts.plugin && std::string_view(all.plugin) != facts.plugin;
    if (!other_plugin) {
      all.plugin = all.plugin ? all.plugin : facts.plugin;
      all.id = all.id ? all.id : facts.id;
      all.library = all.library ? all.library : facts.library;
      if (!all.file) {
        all.file = facts.file;
        all.line = facts.line;
      }
      all.doing = all.doing ? all.doing : facts.doing;
    }
    all.robot = all.robot ? all.robot : facts.robot;
    all.step = all.step != CallFacts::kNoStep ? all.step : facts.step;
  }
  return all;
}

int signal_of_crash() noexcept { return crash_signal; }

bool write_all_now() noexcept {
  bool any = false;
  for (const auto& slot : writers) {
    EmergencyWriter* const writer = slot.load();
    if (writer && writer->thread_ == this_thread()) {
      any = writer->write_now() || any;
    }
  }
  return any;
}

EmergencyWriter::EmergencyWriter() : thread_(this_thread()) {
  for (auto& slot : writers) {
    EmergencyWriter* none = nullptr;
    if (slot.compare_exchange_strong(none, this)) {
      return;
    }
  }
}

void EmergencyWriter::retire() noexcept {
  for (auto& slot : writers) {
    EmergencyWriter* self = this;
    slot.compare_exchange_strong(self, nullptr);
  }
}

}  // namespace elsie::plugin
