#include "elsie/results/run_state.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace elsie::results {
namespace {

/// In the order of RunState.
constexpr std::array<const char*, 6> kWords{"pending", "done", "fault", "crash", "hang", "error"};

}  // namespace

const char* to_string(RunState state) { return kWords[static_cast<std::size_t>(state)]; }

RunState run_state(std::string_view word) {
  const auto* const known = std::find(kWords.begin(), kWords.end(), word);
  if (known == kWords.end()) {
    throw std::invalid_argument("'" + std::string(word) + "' is not a state of a run");
  }
  return static_cast<RunState>(known - kWords.begin());
}

}  // namespace elsie::results
