// Command lines as texts.
#pragma once

#include <string>
#include <vector>

namespace elsie::cluster {

/// A word as a shell takes it, quoted where it has to be.
std::string shell_word(const std::string& word);

/// The words of a command, each quoted where it has to be, with blanks in between.
std::string shell_line(const std::vector<std::string>& words);

}  // namespace elsie::cluster
