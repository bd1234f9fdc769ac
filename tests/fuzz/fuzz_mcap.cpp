// MCAP files, as any program may have written them.
#include "elsie/mcap/reader.h"
#include "elsie/mcap/records.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    elsie::mcap::Reader reader(elsie::fuzz::file_of(data, size));
    while (reader.next()) {
    }
  } catch (const elsie::mcap::McapError&) {
  }
  return 0;
}
