// What the program says to its supervisor when it ends: on a pipe whose number plugins do not know.
#pragma once

#include <cstdint>

namespace elsie::supervisor {

/// The environment variable by which the program finds the pipe: "DESCRIPTOR:TOKEN", both decimal.
/// The program removes it before it loads anything.
inline constexpr const char* kVariable = "ELSIE_SUPERVISOR";

/// The one argument that only the supervisor understands, before all others: no child is made, and
/// the program takes the supervisor's place. For debuggers.
inline constexpr const char* kOneProcess = "--one-process";

/// Short enough that a pipe takes it whole or not at all.
struct Message {
  std::uint64_t token = 0;
  std::int32_t process = 0;
  std::int32_t exit_code = 0;
};

}  // namespace elsie::supervisor
