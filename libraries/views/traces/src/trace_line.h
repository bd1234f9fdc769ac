// One line of a trace, taken apart.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "trace_format.h"

namespace elsie::traces {

/// What is wrong with a line, as the second half of a sentence; the reader adds file and line.
class TraceLineError {
 public:
  explicit TraceLineError(std::string problem) : problem_(std::move(problem)) {}
  const std::string& problem() const { return problem_; }

 private:
  std::string problem_;
};

/// The text in quotes, for a sentence: its first characters, on one line.
std::string shown(std::string_view text);

/// A finite number that is the whole text. Throws TraceLineError, which names the `column`.
double number_in(std::string_view text, std::string_view column);
/// Likewise, in [0, 1].
double degree_in(std::string_view text, std::string_view column);
/// Likewise, a whole number without a sign.
std::uint64_t count_in(std::string_view text, std::string_view column);

/// "# word name="value" ...".
class ParsedRemark {
 public:
  /// `line` begins with "# ". Throws TraceLineError when it is not made like that.
  explicit ParsedRemark(std::string_view line);

  const std::string& word() const { return word_; }
  /// Throws TraceLineError when it is missing.
  const std::string& operator[](std::string_view name) const;

 private:
  struct Field {
    std::string name;
    std::string value;
  };
  std::string word_;
  std::vector<Field> fields_;
};

/// The cells of a row; those left out at its end are empty. They refer to the line, or to the
/// object.
class ParsedRow {
 public:
  /// Throws TraceLineError for a row of too many cells or with a quote out of place.
  void parse(std::string_view line);
  std::string_view operator[](std::size_t column) const { return cells_[column]; }

 private:
  std::array<std::string_view, trace_format::kColumns> cells_;
  std::array<std::string, trace_format::kColumns> unquoted_;
};

}  // namespace elsie::traces
