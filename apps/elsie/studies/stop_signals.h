// Ctrl-C for work that waits for other processes.
#pragma once

#include <array>

#include <signal.h>

namespace elsie::program {

/// While it lives, Ctrl-C (SIGINT), a request to terminate (SIGTERM) and a closed terminal (SIGHUP)
/// make a descriptor readable. A second signal, at least half a second later, ends the process at
/// once, even if the object has been destroyed since the first one. Only one at a time.
class StopSignals {
 public:
  StopSignals();
  ~StopSignals();
  StopSignals(const StopSignals&) = delete;
  StopSignals& operator=(const StopSignals&) = delete;

  int descriptor() const { return ends_[0]; }
  /// True if a signal has come that was not yet read from the descriptor.
  bool is_waiting() const;

 private:
  std::array<int, 2> ends_;
  std::array<struct sigaction, 3> before_;
};

}  // namespace elsie::program
