#include "elsie/world/escaped.h"

namespace elsie::world {

namespace {

std::string replaced(std::string_view text, bool attribute) {
  std::string result;
  result.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\r':
        result += "&#13;";  // a bare one would be read as a line feed
        break;
      case '\n':
        result += attribute ? "&#10;" : "\n";
        break;
      case '\t':
        result += attribute ? "&#9;" : "\t";
        break;
      default:
        result += c;
    }
  }
  return result;
}

}  // namespace

std::string escaped(std::string_view text) { return replaced(text, false); }

std::string escaped_attribute(std::string_view text) { return replaced(text, true); }

}  // namespace elsie::world
