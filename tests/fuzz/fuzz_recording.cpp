// Recordings of runs: the world, the ways of the robots and the result in an MCAP file.
#include <stdexcept>

#include "elsie/recording/recorded_run.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    elsie::recording::read_recorded_run(elsie::fuzz::file_of(data, size));
  } catch (const std::runtime_error&) {
  }
  return 0;
}
