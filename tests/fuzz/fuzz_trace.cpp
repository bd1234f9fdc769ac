// Traces of coordinators.
#include "elsie/simulation/trace.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    elsie::simulation::read_trace(elsie::fuzz::file_of(data, size));
  } catch (const elsie::simulation::TraceError&) {
  }
  return 0;
}
