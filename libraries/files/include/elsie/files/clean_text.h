// Text from sources that may hold any bytes: logs, file names, texts of plugins.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace elsie::files {

/// U+FFFD, which replaces invalid bytes.
inline constexpr std::string_view kReplacement = "\xef\xbf\xbd";
inline constexpr std::string_view kEllipsis = "\xe2\x80\xa6";

/// Text that every reader accepts, also XML readers. U+FFFD replaces each byte that is not UTF-8,
/// each control character except tabs and line feeds, characters that change the direction of
/// writing, and U+FFFE and U+FFFF.
std::string clean(std::string_view text);

/// clean(), on one line: line feeds and tabs become blanks.
std::string one_line(std::string_view text);

/// At most `most` characters of clean(text). An ellipsis replaces the middle of a longer text.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace elsie::files
