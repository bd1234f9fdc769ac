// Exact ranges of decimal numbers, so that no level is called 0.30000000000000004.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

#include "elsie/experiment/reader.h"
#include "elsie/world/values.h"

#include "factors.h"

namespace elsie::experiment {

namespace {

// digits x 10^exponent, as the user wrote it.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

Decimal decimal(double value) {
  std::array<char, 40> buffer;
  const char* end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                  std::chars_format::scientific)
                        .ptr;
  Decimal result;
  bool behind_point = false;
  const char* at = buffer.data();
  const bool negative = *at == '-';
  for (at += negative; *at != 'e'; ++at) {
    if (*at == '.') {
      behind_point = true;
      continue;
    }
    result.digits = result.digits * 10 + (*at - '0');  // at most 17
    result.exponent -= behind_point;
  }
  int exponent = 0;
  std::from_chars(at + (at[1] == '+' ? 2 : 1), end, exponent);
  result.exponent += exponent;
  result.digits = negative ? -result.digits : result.digits;
  return result;
}

[[noreturn]] void refuse(const std::string& message) { throw std::invalid_argument(message); }

// The digits in units of 10^exponent, which must not exceed the number's own exponent.
std::int64_t digits_at(Decimal number, int exponent) {
  while (number.digits != 0 && number.exponent > exponent) {
    if (__builtin_mul_overflow(number.digits, 10, &number.digits)) {
      refuse("its numbers are too far apart in size");
    }
    --number.exponent;
  }
  return number.digits;
}

std::string text_of(std::int64_t digits, int exponent) {
  const std::string text = std::to_string(digits) + "e" + std::to_string(exponent);
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return world::format_value(ParameterValue(value));
}

std::string text_of(double value) { return world::format_value(ParameterValue(value)); }

}  // namespace

std::vector<std::string> range(double from, double to, double step) {
  if (from > to) {
    refuse("there is nothing from " + text_of(from) + " to " + text_of(to) +
           "; give the smaller number first");
  }
  const Decimal first = decimal(from), last = decimal(to), by = decimal(step);
  const int exponent = std::min({first.exponent, last.exponent, by.exponent});
  const std::int64_t begin = digits_at(first, exponent), end = digits_at(last, exponent),
                     stride = digits_at(by, exponent);
  std::int64_t length = 0;
  if (__builtin_sub_overflow(end, begin, &length)) {
    refuse("its numbers are too far apart in size");
  }
  const std::int64_t steps = length / stride;
  if (steps >= static_cast<std::int64_t>(kMostLevels)) {
    refuse("it has " + std::to_string(steps + 1) + " levels; a factor has at most " +
           std::to_string(kMostLevels));
  }
  if (steps * stride != length) {
    refuse("from " + text_of(from) + ", steps of " + text_of(step) + " do not meet " + text_of(to) +
           "; the last one before it is " + text_of(begin + steps * stride, exponent));
  }
  std::vector<std::string> texts;
  for (std::int64_t i = 0; i <= steps; ++i) {
    texts.push_back(text_of(begin + i * stride, exponent));
  }
  return texts;
}

}  // namespace elsie::experiment
