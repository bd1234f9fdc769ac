// Numbers, words and lines of text files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/neural/error.h"

namespace elsie::neural {

using base::counted;
using base::in_quotes;
using base::number_text;

/// Four significant digits, for messages.
inline std::string rough_text(double value) { return number_text(value, 4); }

/// Reads the whole word as a finite number into `value`. Returns the error, "'0,5' is not a
/// number..."; empty if there is none.
std::string read_number(std::string_view word, double& value);
/// The whole word as a whole number of at least `least`.
bool read_count(std::string_view word, long long least, long long& value);

/// The words between tabs and spaces.
std::vector<std::string_view> words_of(std::string_view line);

/// The lines of a text without "\n" or "\r\n". Empty lines at the end and a byte-order mark are
/// left out.
std::vector<std::string_view> lines_of(std::string_view text);

/// The content of a file. Throws FileError when it does not exist, is no file, cannot be read, or
/// is no text. `expected`: "a training file".
std::string read_text_file(const std::string& path, const std::string& expected);
/// The same check for text in memory.
void require_text(std::string_view text, const std::string& name, const std::string& expected);

/// The most problems reported of a file: every line of it can be wrong.
inline constexpr std::size_t kMostProblems = 20;

}  // namespace elsie::neural
