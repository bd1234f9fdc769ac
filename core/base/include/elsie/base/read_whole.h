// Reading whole files of a limited size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace elsie::base {

inline constexpr std::uintmax_t kAnySize = ~std::uintmax_t{0};

/// Why a file cannot be read, to follow the file's name: "is a directory", "is a device, not a
/// file", "is 1100 MB long; files of up to 32 MB are read". "" when no reason is known. Never opens
/// the file: a reader of a pipe would wait, and a device may have no end. `most`: bytes.
std::string why_unreadable(const std::filesystem::path& file, std::uintmax_t most = kAnySize);

/// The content of the file. Throws std::runtime_error with the text of why_unreadable(), or
/// "cannot be read: " and the system's reason.
std::string read_whole(const std::filesystem::path& file, std::uintmax_t most);

}  // namespace elsie::base
