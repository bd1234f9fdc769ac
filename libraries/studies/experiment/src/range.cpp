#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "elsie/experiment/reader.h"
#include "elsie/world/values.h"

#include "factors.h"

namespace elsie::experiment {

namespace {

constexpr double kRounding = 1e-6;  // of a number of steps

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

std::string text_of(double value) { return world::format_value(ParameterValue(value)); }

// To 15 digits of the largest number, so that no level is called 0.30000000000000004.
double rounded(double value, double largest) {
  const int decimals = std::max(14 - static_cast<int>(std::floor(std::log10(largest))), 0);
  std::array<char, 1000> text;
  const char* const end = std::to_chars(text.data(), text.data() + text.size(), value,
                                        std::chars_format::fixed, decimals)
                              .ptr;
  double result = 0.0;
  std::from_chars(text.data(), end, result);
  return result + 0.0;  // no -0
}

}  // namespace

std::vector<std::string> range(double from, double to, double step) {
  if (from > to) {
    refuse("there is nothing from " + text_of(from) + " to " + text_of(to) +
           "; give the smaller number first");
  }
  const double length = (to - from) / step, steps = std::floor(length + kRounding);
  if (!std::isfinite(length)) {
    refuse("its numbers are too far apart in size");
  }
  if (steps >= static_cast<double>(kMostLevels)) {
    refuse("it has " + text_of(steps + 1.0) + " levels; a factor has at most " +
           std::to_string(kMostLevels));
  }
  const double largest = std::max({std::abs(from), std::abs(to), step});
  const auto text_at = [&](double i) { return text_of(rounded(from + i * step, largest)); };
  if (length - steps > kRounding) {
    refuse("from " + text_of(from) + ", steps of " + text_of(step) + " do not meet " + text_of(to) +
           "; the last one before it is " + text_at(steps));
  }
  std::vector<std::string> texts;
  for (double i = 0.0; i <= steps; i += 1.0) {
    texts.push_back(text_at(i));
  }
  return texts;
}

}  // namespace elsie::experiment
