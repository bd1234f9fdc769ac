// The place of libelsie itself.
#pragma once

#include <filesystem>

namespace elsie::plugin {

/// The file with the code of this module: libelsie, or a program that contains it. Empty when the
/// system does not say.
std::filesystem::path file_of_this_library();

}  // namespace elsie::plugin
