// Weight files: what is read is written again to the same.
#include <cstdlib>

#include "elsie/neural/error.h"
#include "elsie/neural/weights.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto weights = elsie::neural::parse_weights(elsie::fuzz::text_of(data, size), "input");
    if (!(elsie::neural::parse_weights(elsie::neural::weights_text(weights), "again") == weights)) {
      std::abort();
    }
  } catch (const elsie::neural::FileError&) {
  }
  return 0;
}
