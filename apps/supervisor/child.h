// The program proper as a child process.
#pragma once

#include <cstdint>
#include <string>

#include <sys/types.h>

#include "channel.h"

namespace elsie::supervisor {

/// How the child ended.
struct End {
  int status = 0;            // as from wait(2)
  bool has_said_so = false;  // it announced its exit code (128 and the signal) and ended with it
  bool was_killed = false;   // by the supervisor, because it did not end after two requests
};

/// Starts the program with these arguments in the same process group and with the same standard
/// streams, forwards signals to it, and waits. Throws std::runtime_error with a sentence when it
/// cannot be started.
End run_child(const std::string& program, char** arguments);

/// Replaces this process by the program. Returns only on failure, with the reason in errno.
void become(const std::string& program, char** arguments);

}  // namespace elsie::supervisor
