// SHA-256, as 64 hexadecimal digits.
#pragma once

#include <string>
#include <string_view>

namespace elsie::results {

std::string sha256(std::string_view bytes);

/// Returns the bytes of a file. Throws std::runtime_error with a sentence if it cannot be read.
std::string file_content(const std::string& path);

}  // namespace elsie::results
