// Measuring in a process of its own, so that what was measured before leaves no traces in memory.
#pragma once

#include <cstdio>
#include <exception>
#include <stdexcept>
#include <type_traits>

#include <sys/wait.h>
#include <unistd.h>

namespace elsie::bench {

/// What `measure` returns in a copy of this process, which must have one thread. Throws
/// std::runtime_error if it fails there; the reason is on standard error.
template <class Measure>
auto apart(Measure measure) {
  using Found = std::invoke_result_t<Measure>;
  static_assert(std::is_trivially_copyable_v<Found>);
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("cannot make a pipe");
  const pid_t child = fork();
  if (child == 0) {
    try {
      const Found found = measure();
      _exit(write(ends[1], &found, sizeof(found)) == sizeof(found) ? 0 : 1);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
  }
  close(ends[1]);
  Found found{};
  const bool is_whole = child > 0 && read(ends[0], &found, sizeof(found)) == sizeof(found);
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  if (!is_whole) throw std::runtime_error("a measurement failed");
  return found;
}

}  // namespace elsie::bench
