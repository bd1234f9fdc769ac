// Lists in the words of users: "a=1|2, b=3".
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace elsie::experiment {

/// Without blanks at both ends.
inline std::string trimmed(const std::string& text) {
  constexpr const char* kBlanks = " \t\r\n";
  const std::size_t from = text.find_first_not_of(kBlanks);
  return from == std::string::npos ? ""
                                   : text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

/// The trimmed parts between separators; at least one.
inline std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(separator, from), text.size());
    parts.push_back(trimmed(text.substr(from, to - from)));
    from = to + 1;
  }
  return parts;
}

}  // namespace elsie::experiment
