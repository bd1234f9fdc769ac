// The libraries of Elsie that this process has loaded.
#pragma once

#include <filesystem>
#include <vector>

namespace elsie::plugin {

/// An address in this module's library. For handlers of signals, too.
const void* place_in_this_library() noexcept;

/// The file with the code of this module: libelsie, or a program that contains it. Empty when the
/// system does not say.
std::filesystem::path file_of_this_library();

/// The libraries that decide the result of a run, besides those of its plugins: libelsie, which is
/// the first, and those that it and its plugins compute with (the base, inference, the views, which
/// take the pictures of cameras, and ODE).
std::vector<std::filesystem::path> deciding_libraries();

}  // namespace elsie::plugin
