// SHA-256, as 64 hexadecimal digits.
#pragma once

#include <string>
#include <string_view>

namespace elsie::results {

std::string sha256(std::string_view bytes);

// Of files. They throw std::runtime_error with a sentence if it cannot be read.

/// The hash of its bytes; does not hold more than a piece of it.
std::string file_sha256(const std::string& path);
/// Its bytes.
std::string file_content(const std::string& path);

}  // namespace elsie::results
