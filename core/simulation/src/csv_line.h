// Lines of comma-separated values.
#pragma once

#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace elsie::simulation {

/// One line in the making. Numbers are the same in every locale.
class CsvLine {
 public:
  /// Quoted when it has to be: also for the sake of readers that take '#' for a comment.
  void text(std::string_view value) {
    separate();
    if (value.find_first_of(",\"\n\r#") == std::string_view::npos) {
      line_ += value;
      return;
    }
    line_ += '"';
    for (const char c : value) {
      line_ += c;
      if (c == '"') {
        line_ += c;
      }
    }
    line_ += '"';
  }
  /// The shortest text that reads as this number, bit for bit.
  void number(double value) {
    separate();
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof(digits), value).ptr;
    line_.append(digits, end);
  }
  void empty() { separate(); }
  /// What was made with another line's take().
  void cells(std::string_view made) {
    separate();
    line_ += made;
  }
  /// The line without its end; the next one begins.
  std::string take() {
    first_ = true;
    return std::exchange(line_, {});
  }
  /// The same, but cells at the end that are empty are left out.
  std::string take_short() {
    line_.erase(line_.find_last_not_of(',') + 1);
    return take();
  }

 private:
  void separate() {
    if (!first_) {
      line_ += ',';
    }
    first_ = false;
  }

  std::string line_;
  bool first_ = true;
};

/// To the given number of decimals, at most 9; never a negative zero.
inline double rounded(double value, int decimals) {
  constexpr double kPowers[] = {1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double power = kPowers[decimals];
  constexpr double kWhole = 1e15;  // beyond it a double has no decimals to speak of
  return std::abs(value) * power < kWhole ? std::round(value * power) / power + 0.0 : value;
}

/// Times as they are written: 0.7, not 0.7000000000000001.
inline double tidy_time(double time_s) { return rounded(time_s, 9); }

}  // namespace elsie::simulation
