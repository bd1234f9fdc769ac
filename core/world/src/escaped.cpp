#include "elsie/world/escaped.h"

namespace elsie::world {

namespace {

// The characters to be replaced, in the same order as their replacements.
constexpr std::string_view kCharacters = "&<>\"\r\n\t";
constexpr std::string_view kReplaced[] = {"&amp;", "&lt;", "&gt;", "&quot;",
                                          "&#13;",  // a bare one would be read as a line feed
                                          "&#10;", "&#9;"};
constexpr std::size_t kBetweenTags = 5;  // between tags, only the first five are replaced

std::string replaced(std::string_view text, std::string_view characters) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    const std::size_t index = characters.find(c);
    if (index == characters.npos) {
      result += c;
    } else {
      result += kReplaced[index];
    }
  }
  return result;
}

}  // namespace

std::string escaped(std::string_view text) {
  return replaced(text, kCharacters.substr(0, kBetweenTags));
}

std::string escaped_attribute(std::string_view text) { return replaced(text, kCharacters); }

}  // namespace elsie::world
