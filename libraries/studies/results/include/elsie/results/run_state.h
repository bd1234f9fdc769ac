// The states of a run in the database.
#pragma once

#include <string_view>

namespace elsie::results {

enum class RunState {
  pending,  // not done yet
  done,     // it ended normally, see its outcome
  fault,    // a plugin failed, and the run was ended cleanly
  crash,    // the process ended without a result, by a signal or because a plugin called exit()
  hang,     // it was ended at the wall limit
  error     // anything else, see its message
};

const char* to_string(RunState state);
/// Throws std::invalid_argument for another word.
RunState run_state(std::string_view word);

}  // namespace elsie::results
