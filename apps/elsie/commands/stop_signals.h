// Ctrl-C for work that waits for other processes.
#pragma once

#include <array>

#include <signal.h>

namespace elsie::program {

/// While it lives, Ctrl-C (SIGINT), a request to terminate (SIGTERM) and a closed terminal (SIGHUP)
/// make a descriptor readable. A second one, half a second later or more, ends the process at once.
/// When one has come, they stay so when it is gone. One at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  int descriptor() const { return ends_[0]; }
  /// Whether one has come, and nobody has read it from the descriptor.
  bool is_waiting() const;

 private:
  std::array<int, 2> ends_;
  std::array<struct sigaction, 3> before_;
};

}  // namespace elsie::program
