#include "stop_signals.h"

#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "repeated_request.h"

namespace elsie::program {

namespace {

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};

// A signal handler can only reach globals.
std::atomic<int> to_write{-1};
RepeatedRequest request;

void stop(int number) {
  const int error = errno;
  switch (request.come()) {
    case RepeatedRequest::Kind::first: {
      [[maybe_unused]] const ssize_t written = ::write(to_write, "!", 1);
      break;
    }
    case RepeatedRequest::Kind::echo:
      break;
    case RepeatedRequest::Kind::second:  // the current work never ends
      signal(number, SIG_DFL);
      raise(number);
      break;
  }
  errno = error;
}

}  // namespace

StopSignals::StopSignals() {
  if (pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
    throw std::runtime_error("signals cannot be waited for: " +
                             std::generic_category().message(errno));
  }
  request.forget();
  to_write = ends_[1];
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    // Ignored hang-ups (nohup) stay ignored; Ctrl-C also ends batches in the background of a
    // script.
    if (kSignals[i] != SIGHUP || before_[i].sa_handler != SIG_IGN) {
      struct sigaction action {};
      action.sa_handler = stop;
      sigemptyset(&action.sa_mask);
      sigaction(kSignals[i], &action, nullptr);
    }
  }
}

bool StopSignals::is_waiting() const {
  pollfd end{ends_[0], POLLIN, 0};
  return poll(&end, 1, 0) > 0;
}

StopSignals::~StopSignals() {
  to_write = -1;
  close(ends_[0]);
  close(ends_[1]);
  if (request.has_come()) {
    return;  // its echoes may follow, and the work is already stopping
  }
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], &before_[i], nullptr);
  }
}

}  // namespace elsie::program
