// Lines of comma-separated values.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "elsie/base/number_text.h"
#include "elsie/files/rounded.h"

namespace elsie::files {

/// The text as one cell (RFC 4180), cleaned by clean(). It is quoted when it holds a comma, a
/// quote, an end of line, or '#', which some readers take for the start of a comment. A text that a
/// spreadsheet would compute, because it begins with '=', '+', '-' or '@' and is no number, gets an
/// apostrophe before it.
std::string csv_cell(std::string_view text);

/// Builds one line after the other. Numbers are the same in every locale.
class CsvLine {
 public:
  void text(std::string_view value) { cells(csv_cell(value)); }
  /// The shortest text that reads as this number, bit for bit.
  void number(double value) { cells(base::NumberText(value).view()); }
  void empty() { separate(); }
  /// Returns the line without its end, and begins the next one.
  std::string take() {
    first_ = true;
    return std::exchange(line_, {});
  }

 private:
  void cells(std::string_view made) {
    separate();
    line_ += made;
  }
  void separate() {
    if (!first_) {
      line_ += ',';
    }
    first_ = false;
  }

  std::string line_;
  bool first_ = true;
};

/// A time as files show it: 0.7, not 0.7000000000000001.
inline double tidy_time(double time_s) { return rounded(time_s, 9); }

}  // namespace elsie::files
