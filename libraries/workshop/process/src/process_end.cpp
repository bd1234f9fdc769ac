#include "elsie/process/process_end.h"

#include <atomic>
#include <csignal>

#include <sys/syscall.h>
#include <unistd.h>

#include "reporting.h"

namespace elsie::process {
namespace {

// Signal handlers can only reach globals.
std::atomic<Announcer> announcer{nullptr};
std::atomic<pid_t> reporter{0};  // the thread that reports the end of the process

pid_t this_thread() { return static_cast<pid_t>(syscall(SYS_gettid)); }

void wait_for_other_report() noexcept {
  while (reporter != 0 && reporter != this_thread()) {
    pause();
  }
}

}  // namespace

bool may_report() noexcept {
  pid_t none = 0;
  if (reporter.compare_exchange_strong(none, this_thread())) {
    std::signal(SIGPIPE, SIG_IGN);  // a report that nobody reads must not change the exit
    return true;
  }
  wait_for_other_report();
  return false;
}

void set_announcer(Announcer of_program) { announcer = of_program; }

void announce_end(int exit_code) noexcept {
  if (const Announcer announce = announcer) {
    announce(exit_code);
  }
}

void end_with(int exit_code) noexcept {
  wait_for_other_report();
  announce_end(exit_code);
  // Not _exit(): the program may define its own.
  for (;;) {
    syscall(SYS_exit_group, exit_code);
  }
}

}  // namespace elsie::process
