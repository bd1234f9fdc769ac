#include "text.h"

#include <cstdint>

#include "elsie/base/number_text.h"
#include "elsie/base/utf8.h"
#include "elsie/output/clean_text.h"

namespace elsie::picture {
namespace {

bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029 ||
         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

}  // namespace

std::string clean_text(std::string_view text, std::size_t max_characters) {
  std::string result;
  std::size_t characters = 0;
  while (!text.empty()) {
    if (characters == max_characters) return result.append(output::kEllipsis);
    const base::Character next = base::character_at(text, 0);
    const std::size_t bytes = next.bytes == 0 ? 1 : next.bytes;
    if (next.bytes == 0) {
      result.append(output::kReplacement);
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
  std::string text = base::number_text(value == 0.0 ? 0.0 : value, 4);
  if (text.front() == '-') text.replace(0, 1, "\xE2\x88\x92");
  return text;
}

}  // namespace elsie::picture
