#include "elsie/base/utf8.h"

#include <algorithm>

namespace elsie::base {

namespace {

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7f && code < 0xa0); }

bool may_stand(std::uint32_t code) {
  return code == '\n' || code == '\t' || (!is_control(code) && code != 0xfffe && code != 0xffff);
}

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
    const std::size_t bytes = character_at(text, at).bytes;
    if (bytes == 0) {
      return at;
    }
    at += bytes;
  }
  return at;
}

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Character next = character_at(text, at);
    const std::size_t bytes = std::max<std::size_t>(next.bytes, 1);
    result += next.bytes > 0 && may_stand(next.code) ? text.substr(at, bytes) : kReplacement;
    at += bytes;
  }
  return result;
}

std::string one_line(std::string_view text) {
  std::string line = clean(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string shortened(std::string_view text, std::size_t most) {
  const std::string whole = clean(text);
  const std::size_t count = characters(whole);
  if (count <= most) {
    return whole;
  }
  const std::size_t kept = most > 1 ? most - 1 : 0;
  const std::size_t front = (kept + 1) / 2, back = kept - front;
  std::string result;
  std::size_t place = 0;
  for (std::size_t at = 0; at < whole.size(); ++place) {
    const std::size_t bytes = character_at(whole, at).bytes;
    if (place < front || place >= count - back) {
      result.append(whole, at, bytes);
    } else if (place == front) {
      result += kEllipsis;
    }
    at += bytes;
  }
  return result;
}

}  // namespace elsie::base
