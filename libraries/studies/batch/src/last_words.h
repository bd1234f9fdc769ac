// What a worker says in the moment in which a plugin brings it down: one line, made within a
// handler of a signal, so without allocating.
//
//   !plugin<TAB>id<TAB>robot<TAB>step<TAB>signal
//
// Parts that are not known are empty; step counts from 0.
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
};

/// The last such line in what a worker answered.
std::optional<LastWords> last_words_in(std::string_view answer);

/// "SIGSEGV", or "signal 42".
std::string signal_name(int number);

}  // namespace elsie::batch
