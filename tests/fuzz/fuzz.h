// What the fuzz targets have in common. A target is given bytes, again and again, and must neither
// crash nor hang on any: bad input ends in the exception that its reader declares, and nothing
// else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "elsie/plugin/host.h"

namespace elsie::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// The bytes as a file, for readers that take no text. In memory; it has the same name each time,
/// and the content of the last call.
std::filesystem::path file_of(const std::uint8_t* data, std::size_t size);

/// The host with all shipped plugins, and where data files are.
const plugin::Host& plugins();
std::string plugin_folder();
std::string source_folder();

}  // namespace elsie::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
