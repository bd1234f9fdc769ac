// Frames of live viewers, as any program may send them.
#include <string_view>

#include "fuzz.h"
#include "protocol.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  elsie::live::request_of_text(bytes);
  elsie::live::request_of_bytes(bytes);
  return 0;
}
