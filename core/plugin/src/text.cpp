#include "text.h"

#include <algorithm>
#include <cctype>

#include "elsie/base/thrown.h"
#include "elsie/plugin/kind_name.h"

namespace elsie::plugin {
namespace {

bool is_symbol_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '$';
}

}  // namespace

std::string title(PluginKind kind, std::string_view name) {
  return std::string(kind_name(kind)).append(" '").append(name).append("'");
}

std::string demangled(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto end = std::find_if_not(text.begin(), text.end(), is_symbol_character);
    const std::string word(text.begin(), end);
    const auto next = std::find_if(end, text.end(), is_symbol_character);
    result += word.starts_with("_Z") ? base::demangled_name(word) : word;
    result.append(end, next);
    text.remove_prefix(static_cast<std::size_t>(next - text.begin()));
  }
  return result;
}

}  // namespace elsie::plugin
