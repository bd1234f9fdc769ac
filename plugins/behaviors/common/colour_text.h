// A colour as a parameter of a behaviour.
#pragma once

#include <charconv>
#include <cstdint>
#include <stdexcept>
#include <string>

#include <elsie/api/image.h>

/// "#2e9e4f". Throws std::invalid_argument with a sentence for anything else.
inline elsie::Colour colour_of(const std::string& text) {
  unsigned rgb = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 7 || text[0] != '#' ||
      std::from_chars(text.data() + 1, end, rgb, 16).ptr != end) {
    throw std::invalid_argument("colour is \"" + text +
                                "\"; expected six hexadecimal digits after #, as in \"#2e9e4f\"");
  }
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}
