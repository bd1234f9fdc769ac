#include "elsie/process/crash_report.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <span>
#include <string_view>

#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "elsie/base/number_text.h"
#include "elsie/base/thrown.h"
#include "elsie/files/emergency.h"
#include "elsie/plugin/call.h"
#include "elsie/process/process_end.h"

#include "loaded_libraries.h"
#include "reporting.h"
#include "stack_trace.h"
#include "thrown.h"

namespace elsie::process {

using plugin::Call;
using plugin::CallFacts;

namespace {

// Signal handlers can only reach globals.
std::atomic<int> status_of_crash{0};
std::atomic<pid_t> own_process{0};  // not that of its children
std::atomic<int> crash_signal{0};
std::atomic<const char*> unsaid{nullptr};  // what happened, until the report says it
std::atomic<bool> names_were_read{false};  // of the plugin, the robot and so on
std::atomic<bool> is_elsewhere{false};     // the call that is reported is of another thread

constexpr std::size_t kStackSize = 262'144;

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
    {SIGTRAP, "ended the program with a breakpoint or trap (SIGTRAP)"},
    {SIGSYS, "ended the program with a system call that is forbidden (SIGSYS)"},
};

/// Whether the signal ends a process that does not handle it, without a fault of its own. Requests
/// to end are left to the program.
bool is_other_end(int signal) {
  constexpr int kOthers[] = {SIGKILL, SIGSTOP, SIGINT,  SIGTERM, SIGHUP, SIGCHLD,
                             SIGCONT, SIGTSTP, SIGTTIN, SIGTTOU, SIGURG, SIGWINCH};
  return std::find(std::begin(kOthers), std::end(kOthers), signal) == std::end(kOthers);
}

void write_number(std::uint64_t number) {
  char digits[20];
  write_error({digits, std::to_chars(digits, digits + sizeof(digits), number).ptr});
}

void write_quoted(const char* before, std::string_view text) {
  write_error(before);
  write_error("'");
  write_error(text);
  write_error("'");
}

/// Whether the thread is in a plugin's code, not only in code that is about to call it.
bool is_plugin_at_work() {
  for (const Call* call = Call::innermost(); call; call = call->outer()) {
    if (call->facts().plugin || call->facts().library) {
      return true;
    }
  }
  return false;
}

/// Whether a plugin is at work in this thread or, if not, in one that shares its work: then this
/// thread takes its call, for the report.
bool find_plugin_at_work() {
  if (is_plugin_at_work()) {
    return true;
  }
  Call* const other = Call::of_shown_threads();
  is_elsewhere = other != nullptr;
  if (other) {
    Call::adopt(other);
  }
  return is_plugin_at_work();
}

void write_culprit(const CallFacts& facts) {
  if (facts.plugin) {
    write_quoted("plugin ", *facts.plugin);
    if (facts.id && *facts.id != *facts.plugin) {
      write_quoted(" (id ", *facts.id);
      write_error(")");
    }
  } else {
    write_quoted("plugin library ", facts.library ? facts.library : "?");
  }
  if (facts.robot) {
    write_quoted(" of robot ", *facts.robot);
  }
}

void write_when(const CallFacts& facts) {
  if (facts.step != CallFacts::kNoStep) {
    constexpr double kPerSecond = 1e6;  // rounded to this: steps are no multiples of binary numbers
    write_error(" in step ");
    write_number(facts.step);
    write_error(" (at ");
    write_error(base::NumberText(std::round(kPerSecond * facts.time_s) / kPerSecond).view());
    write_error(" s)");
  }
  if (facts.doing) {
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

/// Whether a library is being loaded, and has not yet taken long.
bool is_just_loading() {
  constexpr double kLong = 1.0;  // s
  const Call* const call = Call::innermost();
  const double since = call && call->facts().library ? call->own_time_s() : 0.0;
  return since > 0.0 && since < kLong && !facts_at_work().plugin;
}

/// The plugin library on the stack of a thread without calls into plugins, which a plugin has
/// started. Null: none.
const char* library_on_stack(const Fault& place) {
  if (place.at) {
    const char* const library = plugin_library_at(place.at);
    Dl_info info{};
    if (library || dladdr(place.at, &info) == 0) {
      return library;  // the stack cannot be followed from an address without code
    }
  }
  // A thread that starts after its library was unloaded crashes in the C++ library, which looks for
  // the thread's code at the plugin's former address.
  if (const char* const library = plugin_library_at(place.touched)) {
    return library;
  }
  void* frames[64];
  const int count = backtrace(frames, 64);
  for (int i = 0; i < count; ++i) {
    if (const char* const library = plugin_library_at(frames[i])) {
      return library;
    }
  }
  return nullptr;
}

}  // namespace

void write_culprit_and(const char* what, const char* library) {
  write_error("elsie: ");
  if (library) {
    write_quoted("plugin library ", library);
    write_error(", in a thread of its own, ");
    write_error(what);
  } else if (is_plugin_at_work()) {
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

namespace {

void say_what_happened(const char* what, const char* library) {
  if (names_were_read.exchange(true)) {  // and that crashed
    write_error("\nelsie: something whose name is damaged ");
    write_error(what);
    write_error("\n");
  } else {
    write_culprit_and(what, library);
  }
  unsaid = nullptr;
  if (!is_plugin_at_work() && !library && crash_signal != 0) {
    write_error(
        "if a plugin has written over memory that is not its own, this is where it was noticed: "
        "try each with `elsie test-plugin`, or build them with -fsanitize=address\n");
  }
}

}  // namespace

bool write_report(const char* what, const Fault& place) {
  unsaid = what;  // the search on the stack may crash, too
  const bool at_work = is_plugin_at_work();
  const char* const library = at_work ? nullptr : library_on_stack(place);
  say_what_happened(what, library);
  // The important part first: an overwritten stack may end the trace.
  if (files::write_in_emergency()) {
    write_error("what was recorded until then is kept\n");
  }
  if (!is_elsewhere) {
    write_error("the stack, from the inside out:\n");
    write_stack_trace(place);
  }
  files::clean_up_in_emergency();
  return at_work || library;
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

void handle(int signal, void (*handler)(int, siginfo_t*, void*), int flags) {
  struct sigaction action {};
  action.sa_sigaction = handler;
  action.sa_flags = SA_SIGINFO | flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

namespace {

/// Ends the process as it would have ended without the handler.
[[noreturn]] void end_by(int signal) {
  struct sigaction action {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  raise(signal);
  pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
  end_with(128 + signal);
}

void crashed(int signal, siginfo_t* info, void* context) {
  if (getpid() != own_process) {
    end_by(signal);  // a child that a plugin made with fork(): nothing here belongs to it
  }
  if (may_report()) {
    crash_signal = signal;
    const auto crash = std::find_if(std::begin(kCrashes), std::end(kCrashes),
                                    [&](const Crash& known) { return known.signal == signal; });
    Fault place = place_of_fault(context);
    if ((signal == SIGSEGV || signal == SIGBUS) && info->si_code > 0) {
      place.touched = info->si_addr;
    }
    if (write_report(crash->what, place)) {
      end_with(status_of_crash);
    }
    end_by(signal);
  }
  // The report itself has crashed. The stack is not read again.
  if (const char* const what = unsaid) {
    say_what_happened(what, nullptr);
  }
  write_error("  (no more of it can be read)\n");
  files::clean_up_in_emergency();
  if (Call::innermost()) {
    end_with(status_of_crash);
  }
  end_by(signal);
}

/// Whether a timer of this process caused the signal, or the process sent it to itself, as only
/// plugins do. Of pipes whose reader has ended only a plugin's are its fault.
bool is_by_plugin(int signal, const siginfo_t& info) {
  switch (info.si_code) {
    case SI_TIMER:
      return true;
    case SI_KERNEL:
      return signal == SIGALRM || signal == SIGVTALRM || signal == SIGPROF;
    case SI_USER:
    case SI_TKILL:
    case SI_QUEUE:
      return info.si_pid == getpid() && (signal != SIGPIPE || is_plugin_at_work());
    default:
      return false;
  }
}

/// Writes "ended the program with the signal SIGALRM", or "... SIGRTMIN+3".
void name_end(int signal, std::span<char> what) {
  const char* const name = sigabbrev_np(signal);
  const std::string_view words = "ended the program with the signal SIG";
  char* end = std::copy(words.begin(), words.end(), what.data());
  if (name) {
    end = std::copy(name, name + std::strlen(name), end);
  } else {
    constexpr std::string_view kRealTime = "RTMIN+";
    end = std::copy(kRealTime.begin(), kRealTime.end(), end);
    end = std::to_chars(end, what.data() + what.size() - 1, signal - SIGRTMIN).ptr;
  }
  *end = '\0';
}

void ended(int signal, siginfo_t* info, void* context) {
  if (getpid() != own_process) {
    end_by(signal);
  }
  // A session sends it to itself when its window is gone.
  if (signal == SIGQUIT && (find_plugin_at_work() || info->si_pid == getpid())) {
    end_process("was running when the program received SIGQUIT",
                "the program received SIGQUIT while no plugin was running", status_of_crash);
  }
  if (is_by_plugin(signal, *info) && may_report()) {
    char what[64];
    name_end(signal, what);
    write_report(what, place_of_fault(context));
    end_with(status_of_crash);
  }
  if (is_plugin_at_work()) {
    files::write_in_emergency();  // nothing is being written
  }
  files::clean_up_in_emergency();
  end_by(signal);
}

/// In a copy of the process, when the plugin that made it returns: two processes would continue one
/// run and write the same files.
void end_copy() noexcept { end_with(status_of_crash); }

}  // namespace

void report_crashes(int exit_status) {
  status_of_crash = exit_status;
  own_process = getpid();
  Call::watch_for_copies(end_copy);
  watch_libraries();
  prepare_stack_trace();
  base::watch_throws(place_of_throw);
  alignas(16) static char stack[kStackSize];
  stack_t second{};
  second.ss_sp = stack;
  second.ss_size = kStackSize;
  sigaltstack(&second, nullptr);
  for (const Crash& crash : kCrashes) {
    // Not blocked in the handler: a fault in it would end the process at once.
    handle(crash.signal, crashed, SA_ONSTACK | SA_NODEFER);
  }
  for (int signal = 1; signal <= SIGRTMAX; ++signal) {
    struct sigaction before {};
    if (is_other_end(signal) && sigaction(signal, nullptr, &before) == 0 &&
        before.sa_handler == SIG_DFL) {
      handle(signal, ended, 0);
    }
  }
}

void report_crashes_of_copy() { own_process = getpid(); }

void report_exit(const char* function, int exit_code, const void* caller) noexcept {
  if (getpid() != own_process) {
    for (;;) {
      syscall(SYS_exit_group, exit_code);
    }
  }
  if (may_report()) {
    char what[64] = "ended the program by calling ";
    std::strncat(what, function, sizeof(what) - std::strlen(what) - 1);
    write_report(what, {caller, nullptr, nullptr, true});
  }
  end_with(status_of_crash);
}

void end_process(const char* what, const char* else_say, int exit_status, Stack stack) {
  const bool at_work = find_plugin_at_work();
  if (may_report()) {
    if (stack == Stack::left_out && is_just_loading()) {
      write_error("elsie: interrupted while plugins were loaded\n");
    } else if (at_work && stack == Stack::shown) {
      write_report(what, {});
    } else if (at_work) {
      write_culprit_and(what, nullptr);
    } else {  // a recorder may be writing a line: its buffer is not touched
      write_error("elsie: ");
      write_error(else_say);
      write_error("\n");
    }
  }
  files::clean_up_in_emergency();
  end_with(exit_status);
}

CallFacts facts_at_work() noexcept {
  CallFacts all;
  for (const Call* call = Call::innermost(); call; call = call->outer()) {
    const CallFacts& facts = call->facts();
    // Names the library only if the plugin comes from it.
    const bool other_plugin = all.plugin && facts.plugin && *all.plugin != *facts.plugin;
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
    if (all.step == CallFacts::kNoStep) {
      all.step = facts.step;
      all.time_s = facts.time_s;
    }
  }
  return all;
}

int signal_of_crash() noexcept { return crash_signal; }

}  // namespace elsie::process
