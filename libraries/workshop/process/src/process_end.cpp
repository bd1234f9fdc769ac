#include "elsie/process/process_end.h"

#include <atomic>
#include <csignal>

#include <sys/syscall.h>
#include <unistd.h>

#include "reporting.h"

namespace elsie::process {
namespace {

std::atomic<pid_t> ender{0};  // the thread that ends the process, with a report or without

pid_t this_thread() { return static_cast<pid_t>(syscall(SYS_gettid)); }

/// Whether this thread is the first to end the process; false if it has begun to do so before. If
/// another thread has, this one waits for the end.
bool may_end() noexcept {
  pid_t first = 0;
  if (ender.compare_exchange_strong(first, this_thread())) {
    return true;
  }
  while (first != this_thread()) {
    pause();
  }
  return false;
}

}  // namespace

bool may_report() noexcept {
  if (may_end()) {
    std::signal(SIGPIPE, SIG_IGN);  // a report that nobody reads must not change the exit
    return true;
  }
  return false;
}

void end_with(int exit_code) noexcept {
  may_end();  // from here on, other crashes are not reported: the exit code is fixed
  // Not _exit(): the program may define its own.
  for (;;) {
    syscall(SYS_exit_group, exit_code);
  }
}

}  // namespace elsie::process
