// Recordings of runs: the world, the paths of the robots, the decisions and the result.
#include <stdexcept>

#include "elsie/recording/recorded_run.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = elsie::fuzz::file_of(data, size);
  try {
    elsie::recording::read_recorded_run(file);
  } catch (const std::runtime_error&) {
  }
  try {
    elsie::recording::read_trace(file);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
