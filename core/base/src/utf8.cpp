#include "elsie/base/utf8.h"

#include <algorithm>

namespace elsie::base {

namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

}  // namespace

Character character_at(std::string_view text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  if (first < 0x80) {
    return {first, 1};
  }
  Character character;
  std::uint32_t lowest = 0;
  if ((first & 0xe0U) == 0xc0U) {
    character = {first & 0x1fU, 2};
    lowest = 0x80;
  } else if ((first & 0xf0U) == 0xe0U) {
    character = {first & 0x0fU, 3};
    lowest = 0x800;
  } else if ((first & 0xf8U) == 0xf0U) {
    character = {first & 0x07U, 4};
    lowest = 0x10000;
  }
  if (character.bytes == 0 || text.size() - at < character.bytes) {
    return {};
  }
  for (std::size_t i = 1; i < character.bytes; ++i) {
    if (!continues(text[at + i])) {
      return {};
    }
    character.code = (character.code << 6U) | (static_cast<unsigned char>(text[at + i]) & 0x3fU);
  }
  const bool surrogate = character.code >= 0xd800 && character.code <= 0xdfff;
  return character.code < lowest || surrogate || character.code > 0x10ffff ? Character{}
                                                                           : character;
}

std::size_t first_invalid(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const bool is_ascii = static_cast<unsigned char>(text[at]) < 0x80;
    const std::size_t bytes = is_ascii ? 1 : character_at(text, at).bytes;
    if (bytes == 0) return at;
    at += bytes;
  }
  return at;
}

std::size_t cut_before(std::string_view text, std::size_t at) {
  at = std::min(at, text.size());
  while (at > 0 && at < text.size() && continues(text[at])) {
    --at;
  }
  return at;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

}  // namespace elsie::base
