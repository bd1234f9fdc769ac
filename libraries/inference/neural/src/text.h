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
using base::number_text;
using base::in_quotes;

/// Four significant digits, for messages.
inline std::string rough_text(double value) { return number_text(value, 4); }

/// The whole word as a finite number, in `value`; else what is wrong with it: "'0,5' is not a
/// number...". Empty: nothing is.
std::string read_number(std::string_view word, double& value);
/// The whole word as a whole number of at least `least`.
bool read_count(std::string_view word, long long least, long long& value);

/// What stands between tabs and spaces.
std::vector<std::string_view> words_of(std::string_view line);

/// The lines of a text, with "\n" or "\r\n" taken off; empty ones at the end are left out. So is a
/// byte-order mark.
std::vector<std::string_view> lines_of(std::string_view text);

/// The whole file. Throws FileError, when it is not there, not a file, not to be read, or no text.
/// `expected`: "a training file".
std::string read_text_file(const std::string& path, const std::string& expected);
/// For text that is in memory.
void require_text(std::string_view text, const std::string& name, const std::string& expected);

/// Training and weight files can be wrong in every one of their lines.
inline constexpr std::size_t kMostProblems = 20;

}  // namespace elsie::neural
