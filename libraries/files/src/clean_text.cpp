#include "elsie/files/clean_text.h"

#include <algorithm>
#include <cstdint>

#include "elsie/base/utf8.h"

namespace elsie::files {

namespace {

// Also ends of lines and of paragraphs, and characters that change the direction of writing.
bool is_control(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0x2028 || code == 0x2029 ||
         (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
}

bool may_stand(std::uint32_t code) {
  return code == '\n' || code == '\t' || (!is_control(code) && code != 0xfffe && code != 0xffff);
}

}  // namespace

std::string clean(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const base::Character next = base::character_at(text, at);
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

std::string shortened(std::string_view text, std::size_t most) {
  const std::string whole = clean(text);
  const std::size_t count = base::characters(whole);
  if (count <= most) {
    return whole;
  }
  const std::size_t kept = most > 1 ? most - 1 : 0;
  const std::size_t front = (kept + 1) / 2, back = kept - front;
  std::string result;
  std::size_t place = 0;
  for (std::size_t at = 0; at < whole.size(); ++place) {
    const std::size_t bytes = base::character_at(whole, at).bytes;
    if (place < front || place >= count - back) {
      result.append(whole, at, bytes);
    } else if (place == front) {
      result += kEllipsis;
    }
    at += bytes;
  }
  return result;
}

}  // namespace elsie::files
