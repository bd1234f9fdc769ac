// Numbers, words and lines of text files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/neural/error.h"

namespace elsie::neural {

/// The shortest decimal that reads back as the same number.
std::string number_text(double value);
/// For messages: four significant digits.
std::string rough_text(double value);

/// The whole word as a finite number, in `value`; else what is wrong with it: "'0,5' is not a
/// number...". Empty: nothing is.
std::string read_number(std::string_view word, double& value);
/// The whole word as a whole number of at least `least`.
bool read_count(std::string_view word, long long least, long long& value);

/// What stands between tabs and spaces.
std::vector<std::string_view> words_of(std::string_view line);
/// A word as it may be shown in a message: cut when it is long, "?" for what cannot be printed.
std::string quoted(std::string_view word);

/// "1 number", "3 numbers".
std::string count_text(std::size_t count, std::string_view thing);

/// The lines of a text, with "\n" or "\r\n" taken off; empty ones at the end are left out. So is a
/// byte-order mark.
std::vector<std::string_view> lines_of(std::string_view text);

/// The whole file. Throws FileError, when it is not there, not a file, not to be read, or no text.
/// `expected`: "a training file".
std::string read_text_file(const std::string& path, const std::string& expected);
/// For text that is in memory.
void require_text(std::string_view text, const std::string& name, const std::string& expected);

/// Collects what is wrong with one file, up to a number that a user wants to read.
class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}
  void add(std::size_t line, std::string message);
  bool any() const { return !problems_.empty(); }
  void throw_if_any();

 private:
  std::string file_;
  std::vector<Problem> problems_;
  std::size_t left_out_ = 0;
};

}  // namespace elsie::neural
