// Experiment files, without their worlds.
#include "elsie/experiment/reader.h"
#include "elsie/world/error.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    elsie::experiment::parse_outline(elsie::fuzz::text_of(data, size), "input.xml");
  } catch (const elsie::world::WorldError&) {
  }
  return 0;
}
