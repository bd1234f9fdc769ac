// Files that are read whole, if they are of a kind and a size that can be.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace elsie::base {

inline constexpr std::uintmax_t kAnySize = ~std::uintmax_t{0};

/// What keeps a file from being read, as it follows "this" or the file's name: "is a directory",
/// "is a device, not a file", "is a pipe, not a file", "is 1100 MB long; files of up to 32 MB are
/// read".
/// "": nothing that can be known without opening it. Never opens the file: a pipe would make its
/// reader wait, and a device may have no end. `most`: bytes.
std::string why_unreadable(const std::filesystem::path& file, std::uintmax_t most = kAnySize);

/// What is in the file. Throws std::runtime_error with what why_unreadable() says, or with the
/// system's reason after "cannot be read: ".
std::string read_whole(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace elsie::base
