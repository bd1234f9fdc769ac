#include "elsie/picture/svg.h"

#include <algorithm>
#include <cmath>

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

PathData::PathData(int decimals) : decimals_(decimals), scale_(std::pow(10.0, decimals)) {}

// Points far outside of the picture are moved to a limit outside of it.
PathData::Place PathData::place_of(const Vector2& point) const {
  const auto rounded = [&](double value) {
    return std::lround(scale_ * std::clamp(value, -1e5, 1e5));
  };
  return {rounded(point.x), rounded(point.y)};
}

void PathData::append(long value) {
  const std::string number = short_number(static_cast<double>(value) / scale_, decimals_);
  const bool apart = !text_.empty() && text_.back() >= '0' && text_.back() <= '9';
  if (apart && number.front() != '-') text_ += ' ';
  text_ += number;
}

void PathData::move_to(const Vector2& to) {
  at_ = start_ = place_of(to);
  last_ = 0;
}

void PathData::add(char command, std::span<const Vector2> points) {
  if (command == 'l' && last_ == 'l' && place_of(points[0]) == at_) return;
  if (last_ == 0) {
    text_ += 'M';
    append(at_.x);
    append(at_.y);
  }
  if (last_ != command) text_ += command;
  last_ = command;
  const Place from = at_;
  for (const Vector2& point : points) {
    at_ = place_of(point);
    append(at_.x - from.x);
    append(at_.y - from.y);
  }
}

void PathData::close() {
  if (last_ != 0) text_ += 'z';
  at_ = start_;
  last_ = 0;
}

void PathData::polyline(std::span<const Vector2> points) {
  if (points.empty()) return;
  move_to(points.front());
  for (const Vector2& point : points.subspan(1)) line_to(point);
}

}  // namespace elsie::picture
