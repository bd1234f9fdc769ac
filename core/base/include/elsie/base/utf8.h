// UTF-8 (RFC 3629) from sources that may hold any bytes: logs, file names, texts of plugins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace elsie::base {

/// U+FFFD, which replaces invalid bytes.
inline constexpr std::string_view kReplacement = "\xef\xbf\xbd";
inline constexpr std::string_view kEllipsis = "\xe2\x80\xa6";

/// One character.
struct Character {
  std::uint32_t code = 0;  // its code point
  std::size_t bytes = 0;   // 1 to 4; 0: no character
};

/// The character that begins at `at`, which is less than the text's size; none when the bytes are
/// not UTF-8. Overlong forms, surrogates and codes above U+10FFFF are not UTF-8.
Character character_at(std::string_view text, std::size_t at);

/// The place of the first byte that is not UTF-8; the text's size when there is none.
std::size_t first_invalid(std::string_view text);

/// Text that every reader accepts, also one of XML. U+FFFD replaces each byte that is not UTF-8,
/// each control character but tabs and line feeds, and U+FFFE and U+FFFF.
std::string clean(std::string_view text);

/// clean(), on one line: line feeds and tabs become blanks.
std::string one_line(std::string_view text);

/// The number of characters of UTF-8.
std::size_t characters(std::string_view text);

/// At most `most` characters of clean(text). An ellipsis replaces the middle of a longer text.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace elsie::base
