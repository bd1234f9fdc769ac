// The message of the program to its supervisor at its end, on a pipe whose number plugins do not
// know.
#pragma once

#include <cstdint>

namespace elsie::supervisor {

/// The environment variable with the pipe: "DESCRIPTOR:TOKEN", both decimal. The program removes it
/// before it loads anything.
inline constexpr const char* kVariable = "ELSIE_SUPERVISOR";

/// The supervisor's only argument, before all others: instead of starting a child, the program
/// replaces the supervisor. For debuggers.
inline constexpr const char* kOneProcess = "--one-process";

/// Short enough for a pipe to take it whole or not at all.
struct Message {
  std::uint64_t token = 0;
  std::int32_t process = 0;
  std::int32_t exit_code = 0;
};

}  // namespace elsie::supervisor
