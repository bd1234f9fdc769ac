// The states of a run in the database.
#pragma once

#include <string_view>

namespace elsie::results {

/// `pending`: the run is not done yet. For the others see `runs` in schema.sql.
enum class RunState { pending, done, fault, crash, hang, error };

const char* to_string(RunState state);
/// Throws std::invalid_argument for another word.
RunState run_state(std::string_view word);

}  // namespace elsie::results
