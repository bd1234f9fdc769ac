// The program proper as a child process.
#pragma once

#include <cstdint>
#include <string>

#include <sys/types.h>

#include "channel.h"

namespace elsie::supervisor {

/// How the child ended.
struct End {
  int status = 0;            // as wait(2) has it
  bool has_said_so = false;  // it sent its exit code (128 and the signal's number), and ended so
  bool was_killed = false;   // by the supervisor, because it did not end when asked twice
};

/// Starts the program with these arguments, in the same process group and with the same standard
/// streams, hands on the signals that this process gets, and waits. Throws std::runtime_error with
/// a sentence when it cannot be started.
End run_child(const std::string& program, char** arguments);

/// Lets the program take the place of this process. Returns only when that fails; errno says why.
void become(const std::string& program, char** arguments);

}  // namespace elsie::supervisor
