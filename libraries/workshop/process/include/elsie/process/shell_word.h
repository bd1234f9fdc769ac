// Command lines as text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace elsie::process {

/// A word for a POSIX shell, quoted where needed.
std::string shell_word(std::string_view word);

/// The words of a command, each quoted where needed, with blanks in between.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace elsie::process
