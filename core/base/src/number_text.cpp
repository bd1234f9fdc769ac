#include "elsie/base/number_text.h"

#include <array>
#include <charconv>

namespace elsie::base {
namespace {

template <class... Format>
std::string converted(double value, Format... format) {
  std::array<char, 400> buffer;  // the largest double has 309 digits before the point
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
  return {buffer.data(), result.ptr};
}

}  // namespace

NumberText::NumberText(double value) noexcept
    : size_(static_cast<std::size_t>(std::to_chars(digits_, digits_ + sizeof digits_, value).ptr -
                                     digits_)) {}

std::string number_text(double value) { return std::string(NumberText(value).view()); }

std::string number_text(double value, int digits) {
  return converted(value, std::chars_format::general, digits);
}

std::string fixed_text(double value, int decimals) {
  const std::string text = converted(value, std::chars_format::fixed, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::string seconds_text(double seconds) { return number_text(seconds, 6) + " s"; }

std::string step_text(std::uint64_t step, double time_s) {
  return "step " + std::to_string(step) + " (at " + seconds_text(time_s) + ")";
}

}  // namespace elsie::base
