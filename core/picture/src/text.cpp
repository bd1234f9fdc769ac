#include "text.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace elsie::picture {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kEllipsis = "\xE2\x80\xA6";

struct Decoded {
  std::uint32_t code = 0;
  std::size_t bytes = 0;  // 0: not UTF-8
};

// The first code point, by the table of well-formed sequences of the Unicode standard (3.9, D92).
Decoded decode(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned first = byte(0);
  if (first < 0x80) return {first, 1};
  std::size_t bytes = 0;
  std::uint32_t code = 0, lowest = 0;
  if ((first & 0xe0U) == 0xc0U) {
    bytes = 2, code = first & 0x1fU, lowest = 0x80;
  } else if ((first & 0xf0U) == 0xe0U) {
    bytes = 3, code = first & 0x0fU, lowest = 0x800;
  } else if ((first & 0xf8U) == 0xf0U) {
    bytes = 4, code = first & 0x07U, lowest = 0x10000;
  } else {
    return {};
  }
  if (text.size() < bytes) return {};
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80U) return {};
    code = (code << 6U) | (byte(i) & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < lowest || surrogate || code > 0x10ffff) return {};
  return {code, bytes};
}

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029 ||
         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string clean_text(std::string_view text, std::size_t max_characters) {
  std::string result;
  std::size_t characters = 0;
  while (!text.empty()) {
    if (characters == max_characters) return result.append(kEllipsis);
    const Decoded next = decode(text);
    const std::size_t bytes = next.bytes == 0 ? 1 : next.bytes;
    if (next.bytes == 0) {
      result.append(kReplacement);
    } else if (is_control(next.code)) {
      result.push_back(' ');
    } else {
      result.append(text.substr(0, bytes));
    }
    text.remove_prefix(bytes);
    ++characters;
  }
  return result;
}

std::string without_tail(const std::string& text, std::size_t characters) {
  std::size_t end = text.size();
  while (characters > 0 && end > 0) {
    --end;
    if ((static_cast<unsigned char>(text[end]) & 0xc0U) != 0x80U) --characters;
  }
  return text.substr(0, end);
}

std::string with_unit(const std::string& label, const std::string& unit) {
  if (unit.empty()) return label;
  return label.empty() ? unit : label + " (" + unit + ")";
}

std::string number_text(double value) {
  std::array<char, 64> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                 value == 0.0 ? 0.0 : value, std::chars_format::general, 4)
                       .ptr;
  std::string text(buffer.data(), end);
  if (text.front() == '-') text.replace(0, 1, "\xE2\x88\x92");
  return text;
}

}  // namespace elsie::picture
