#include "elsie/base/words.h"

#include <algorithm>

#include "elsie/base/utf8.h"

namespace elsie::base {

std::string counted(std::uint64_t count, std::string_view one, std::string_view several) {
  return std::to_string(count).append(" ").append(count == 1 ? one : several);
}

std::string counted(std::uint64_t count, std::string_view what) {
  return counted(count, what, std::string(what) + 's');
}

std::string joined(const std::vector<std::string>& items, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    text.append(i == 0 ? "" : separator).append(items[i]);
  }
  return text;
}

std::string listed(const std::vector<std::string>& items) {
  constexpr std::size_t kMost = 20;
  if (items.size() <= kMost) return joined(items);
  return joined({items.begin(), items.begin() + kMost}) + " and " +
         std::to_string(items.size() - kMost) + " more";
}

std::string enumerated(const std::vector<std::string>& items, std::string_view last) {
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += i + 1 < items.size() ? ", " : " " + std::string(last) + " ";
    text += items[i];
  }
  return text;
}

std::string in_quotes(std::string_view word, std::size_t most) {
  const std::size_t shown = cut_before(word, most);
  std::string text(word.substr(0, shown));
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; }, '?');
  return "'" + text + (shown < word.size() ? "..." : "") + "'";
}

}  // namespace elsie::base
