// World files: read, written, and read again to the same text.
#include <cstdlib>

#include "elsie/world/error.h"
#include "elsie/world/reader.h"
#include "elsie/world/writer.h"

#include "fuzz.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const elsie::plugin::Host& host = elsie::fuzz::plugins();
  elsie::world::ReadOptions options;
  options.data_directories = {elsie::fuzz::source_folder()};
  const std::string file = elsie::fuzz::source_folder() + "/worlds/input.xml";
  try {
    const auto world =
        elsie::world::parse_world(elsie::fuzz::text_of(data, size), file, host, options);
    const std::string text = elsie::world::write_world(world);
    const auto again = elsie::world::parse_world(text, file, host, options);
    if (elsie::world::write_world(again) != text) {
      std::abort();
    }
  } catch (const elsie::world::WorldError&) {
  }
  return 0;
}
