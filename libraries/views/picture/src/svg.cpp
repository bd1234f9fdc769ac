#include "elsie/picture/svg.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "elsie/base/number_text.h"

namespace elsie::picture {

std::string short_number(double value, int decimals) {
  std::string text = base::fixed_text(value, decimals);
  if (decimals > 0) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

std::string hex_text(const Colour& colour) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string text = "#";
  for (const unsigned part : {colour.red, colour.green, colour.blue}) {
    text += kDigits[part / 16];
    text += kDigits[part % 16];
  }
  return text;
}

std::string path_data(std::span<const Vector2> line, int decimals, bool closed) {
  const double scale = std::pow(10.0, decimals);
  // Points far outside of the picture are moved to a limit outside of it.
  const auto rounded = [&](double value) {
    return std::lround(scale * std::clamp(value, -1e5, 1e5));
  };
  std::string text;
  const auto append = [&](long value) {
    const std::string number = short_number(static_cast<double>(value) / scale, decimals);
    if (number.front() != '-' && text.back() >= '0' && text.back() <= '9') text += ' ';
    text += number;
  };
  long x = 0, y = 0;
  for (const Vector2& point : line) {
    const long from_x = std::exchange(x, rounded(point.x));
    const long from_y = std::exchange(y, rounded(point.y));
    const bool begins = text.empty();
    if (!begins && text.back() != 'l' && x == from_x && y == from_y) continue;
    if (begins) text = "M";
    append(x - from_x);
    append(y - from_y);
    if (begins) text += 'l';
  }
  if (text.ends_with('l')) text += "0 0";  // round ends make it a dot
  return closed ? text + 'z' : text;
}

}  // namespace elsie::picture
