#include "markup.h"

#include <algorithm>

namespace elsie::report {

namespace {

constexpr const char* kReplacement = "\xef\xbf\xbd";

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; }

// The bytes of the character of UTF-8 that begins at `at`, or 0 when none does: not overlong, no
// surrogate, no more than U+10FFFF, none of the two that XML leaves out.
std::size_t length_at(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[at + i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || at + length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[at + i])) return 0;
  }
  if ((first == 0xe0 && byte(1) < 0xa0) || (first == 0xed && byte(1) > 0x9f) ||
      (first == 0xf0 && byte(1) < 0x90) || (first == 0xf4 && byte(1) > 0x8f) ||
      (first == 0xef && byte(1) == 0xbf && byte(2) > 0xbd)) {
    return 0;
  }
  return length;
}

std::string replaced(std::string_view text, bool attribute) {
  std::string result;
  for (const char c : clean(text)) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&#39;";
        break;
      case '\n':
        result += attribute ? "&#10;" : "\n";
        break;
      case '\t':
        result += attribute ? "&#9;" : "\t";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = length_at(text, at);
    const auto c = static_cast<unsigned char>(text[at]);
    const bool control = length == 1 && (c < 0x20 || c == 0x7f) && c != '\n' && c != '\t';
    if (length == 0 || control) {
      result += kReplacement;
    } else {
      result += text.substr(at, length);
    }
    at += std::max<std::size_t>(length, 1);
  }
  return result;
}

std::string escaped(std::string_view text) { return replaced(text, false); }

std::string escaped_attribute(std::string_view text) { return replaced(text, true); }

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !continues(c); }));
}

std::string shortened(std::string_view text, std::size_t most) {
  const std::string whole = clean(text);
  const std::size_t count = characters(whole);
  if (count <= most) return whole;
  const std::size_t kept = most > 1 ? most - 1 : 0;
  const std::size_t front = (kept + 1) / 2, back = kept - front;
  std::string result;
  std::size_t at = 0;
  bool gap = false;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    const std::size_t place = at;
    at += i + 1 == whole.size() || !continues(whole[i + 1]) ? 1 : 0;
    if (place < front || place >= count - back) {
      result += whole[i];
    } else if (!gap) {
      result += "\xe2\x80\xa6";
      gap = true;
    }
  }
  return result;
}

}  // namespace elsie::report
