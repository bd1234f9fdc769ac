// The library that holds this module.
#pragma once

#include <filesystem>

namespace elsie::plugin {

/// An address in this module's library. Signal handlers may use it.
const void* place_in_this_library() noexcept;

/// The file with the code of this module: libelsie, or a program that contains it; "" if unknown.
std::filesystem::path file_of_this_library();

}  // namespace elsie::plugin
