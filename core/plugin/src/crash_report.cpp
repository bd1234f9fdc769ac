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
namespace {

// All that a handler of signals can reach are globals, and so is what is told to all handlers.
std::array<std::atomic<EmergencyWriter*>, 512> writers;
std::atomic<int> status_of_crash{0};
std::atomic_flag is_reporting;

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

/// What is known of a call and those around it. Of the library only what belongs to the plugin.
CallFacts all_facts(const Call* call) {
  CallFacts all;
  for (; call; call = call->outer()) {
    const CallFacts& facts = call->facts();
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

void clean_up() {
  for (const auto& slot : writers) {
    if (EmergencyWriter* const writer = slot.load()) {
      writer->clean_up_now();
    }
  }
}

void write_report(const char* what, const void* at) {
  write_error("elsie: ");
  if (const Call* const call = Call::innermost()) {
    const CallFacts facts = all_facts(call);
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
  bool kept = false;
  for (const auto& slot : writers) {
    if (EmergencyWriter* const writer = slot.load()) {
      kept = writer->write_now() || kept;
    }
  }
  write_error("the stack, from the inside out:\n");
  write_stack_trace(at);
  if (kept) {
    write_error("what was recorded until then is kept\n");
  }
  clean_up();
}

const void* address_of(const void* context) {
#if defined(__x86_64__)
  return reinterpret_cast<const void*>(
      static_cast<const ucontext_t*>(context)->uc_mcontext.gregs[REG_RIP]);
#elif defined(__aarch64__)
  return reinterpret_cast<const void*>(static_cast<const ucontext_t*>(context)->uc_mcontext.pc);
#else
  static_cast<void>(context);
  return nullptr;
#endif
}

void crashed(int signal, siginfo_t*, void* context) {
  if (is_reporting.test_and_set()) {
    _exit(status_of_crash);  // the report itself came to grief
  }
  const auto crash = std::find_if(std::begin(kCrashes), std::end(kCrashes),
                                  [&](const Crash& known) { return known.signal == signal; });
  write_report(crash->what, address_of(context));
  if (Call::innermost()) {
    _exit(status_of_crash);
  }
  // As it would have ended by itself. The signal is blocked until this returns.
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void left_by_exit() {
  if (Call::innermost() && !is_reporting.test_and_set()) {
    write_report("ended the program by calling exit()", nullptr);
    _exit(status_of_crash);
  }
}

void look_for_endless_call(int, siginfo_t*, void* context) {
  const Call* const call = Call::innermost();
  if (call && 1e9 * call->own_time_s() > static_cast<double>(watchdog_limit_ns.load()) &&
      !is_reporting.test_and_set()) {
    write_report("did not return within its time budget and was stopped", address_of(context));
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
    handle(crash.signal, crashed, SA_ONSTACK);
  }
}

void end_process(const char* what, int exit_status) {
  if (!is_reporting.test_and_set()) {
    // Elsewhere a recorder may be in the middle of a line: what it holds is left alone.
    if (Call::innermost()) {
      write_report(what, nullptr);
    } else {
      write_error("elsie: something outside of all plugins ");
      write_error(what);
      write_error("\n");
      clean_up();
    }
  }
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
  event._sigev_un._tid = static_cast<pid_t>(syscall(SYS_gettid));
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

EmergencyWriter::EmergencyWriter() {
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
