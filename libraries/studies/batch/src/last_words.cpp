#include "last_words.h"

#include <array>
#include <charconv>
#include <cstring>

#include <signal.h>

namespace elsie::batch {

std::optional<LastWords> last_words_in(std::string_view answer) {
  std::optional<LastWords> found;
  while (!answer.empty()) {
    const std::string_view line = answer.substr(0, answer.find('\n'));
    answer.remove_prefix(std::min(line.size() + 1, answer.size()));
    if (!line.starts_with('!')) {
      continue;
    }
    std::array<std::string, 6> parts;
    std::string_view rest = line.substr(1);
    for (std::string& part : parts) {
      const std::string_view text = rest.substr(0, rest.find('\t'));
      rest.remove_prefix(std::min(text.size() + 1, rest.size()));
      part = text;
    }
    LastWords words{parts[0], parts[1], parts[2], std::nullopt, parts[4]};
    std::from_chars(parts[5].data(), parts[5].data() + parts[5].size(), words.time_s);
    std::uint64_t step = 0;
    const char* const end = parts[3].data() + parts[3].size();
    if (const auto read = std::from_chars(parts[3].data(), end, step);
        read.ec == std::errc() && read.ptr == end) {
      words.step = step;
    }
    found = std::move(words);
  }
  return found;
}

std::string signal_name(int number) {
  const char* const name = sigabbrev_np(number);
  return name ? std::string("SIG") + name : "signal " + std::to_string(number);
}

}  // namespace elsie::batch
