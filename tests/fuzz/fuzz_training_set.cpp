// Training files.
#include "elsie/neural/error.h"
#include "elsie/neural/training_set.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto& columns : {elsie::neural::Columns{2, 1}, elsie::neural::Columns{8, 2}}) {
    try {
      elsie::neural::parse_training_set(elsie::fuzz::text_of(data, size), columns, "input");
    } catch (const elsie::neural::FileError&) {
    }
  }
  return 0;
}
