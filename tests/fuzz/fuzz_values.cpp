// Files of learned values: what is read is written again to the same.
#include <cstdlib>

#include "elsie/learning/values.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace elsie::learning;
  try {
    const Values values = parse_values(elsie::fuzz::text_of(data, size), "input");
    if (!(parse_values(values_text(values), "again") == values)) {
      std::abort();
    }
  } catch (const FileError&) {
  }
  return 0;
}
