// Command lines as texts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace elsie::base {

/// A word as a POSIX shell takes it, quoted where it has to be.
std::string shell_word(std::string_view word);

/// The words of a command, each quoted where it has to be, with blanks in between.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace elsie::base
