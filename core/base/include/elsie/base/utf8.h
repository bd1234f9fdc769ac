// UTF-8 (RFC 3629), from sources that may hold anything: logs, file names, what plugins say.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace elsie::base {

/// U+FFFD, which stands for what could not be read.
inline constexpr std::string_view kReplacement = "\xef\xbf\xbd";
inline constexpr std::string_view kEllipsis = "\xe2\x80\xa6";

/// One character.
struct Character {
  std::uint32_t code = 0;  // its code point
  std::size_t bytes = 0;   // how long it is, 1 to 4; 0: there is none
};

/// The character that begins at `at`, which is less than the text's size. None when these bytes are
/// no UTF-8: overlong forms, surrogates and what is above U+10FFFF are none either.
Character character_at(std::string_view text, std::size_t at);

/// The first place where no character begins; the text's size when all of it is UTF-8.
std::size_t first_invalid(std::string_view text);

/// Text that any reader takes, also of XML: bytes that are no UTF-8, control characters but tabs
/// and line feeds, and the two code points that XML leaves out are replaced by U+FFFD, one for each
/// byte or character.
std::string clean(std::string_view text);

/// clean(), on one line: line feeds and tabs become blanks.
std::string one_line(std::string_view text);

/// The number of characters of UTF-8.
std::size_t characters(std::string_view text);

/// At most so many characters of clean(text), of which an ellipsis in the middle is one when some
/// had to go.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace elsie::base
