// The report of a worker that a plugin is just ending: one line, written in a signal handler and so
// without allocation.
//
//   !plugin<TAB>id<TAB>robot<TAB>step<TAB>signal<TAB>time
//
// Unknown parts are empty; the step counts from 0, and its time is simulated seconds.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace elsie::batch {

struct LastWords {
  std::string plugin;
  std::string id;
  std::string robot;
  std::optional<std::uint64_t> step;
  std::string signal;
  double time_s = 0.0;  // of the step
};

/// Finds the last such line in a worker's answer.
std::optional<LastWords> last_words_in(std::string_view answer);

/// The name of a signal: "SIGSEGV", or "signal 42".
std::string signal_name(int number);

}  // namespace elsie::batch
