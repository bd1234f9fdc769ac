// Traces of coordinators.
#include "elsie/traces/trace.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    elsie::traces::read_trace(elsie::fuzz::file_of(data, size));
  } catch (const elsie::traces::TraceError&) {
  }
  return 0;
}
