// Private copies of libraries.
#pragma once

#include <filesystem>
#include <memory>

namespace elsie::build {

/// A copy of a library in a folder of its own, for plugin::Host; it is removed with its last owner,
/// and when the process crashes or is stopped. The first copy of a process removes the copies of
/// killed processes of this user. Throws std::runtime_error with a sentence, also when other users
/// could replace the copy before it is loaded.
std::shared_ptr<const std::filesystem::path> private_copy(const std::filesystem::path& library);

}  // namespace elsie::build
