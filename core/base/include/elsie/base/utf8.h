// UTF-8 (RFC 3629).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace elsie::base {

/// One character.
struct Character {
  std::uint32_t code = 0;  // its code point
  std::size_t bytes = 0;   // 1 to 4; 0: no character
};

/// The character that begins at `at`, which must be less than the text's size; none when the bytes
/// are not UTF-8. Overlong forms, surrogates and codes above U+10FFFF are not UTF-8.
Character character_at(std::string_view text, std::size_t at);

/// The index of the first byte that is not UTF-8; the text's size when there is none.
std::size_t first_invalid(std::string_view text);

/// The largest index up to `at` at which a character begins or the text ends: a cut there leaves
/// all characters whole.
std::size_t cut_before(std::string_view text, std::size_t at);

/// The number of characters.
std::size_t characters(std::string_view text);

}  // namespace elsie::base
