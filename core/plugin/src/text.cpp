#include "text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>

#include <cxxabi.h>

#include "elsie/plugin/kind_name.h"

namespace elsie::plugin {
namespace {

std::string demangled_name(const std::string& name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> readable(
      abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
  return status == 0 && readable ? std::string(readable.get()) : name;
}

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
    result += word.starts_with("_Z") ? demangled_name(word) : word;
    result.append(end, next);
    text.remove_prefix(static_cast<std::size_t>(next - text.begin()));
  }
  return result;
}

std::string current_exception_text() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    const std::type_info* const type = abi::__cxa_current_exception_type();
    return "an exception of type " + (type ? demangled_name(type->name()) : "unknown to C++");
  }
}

}  // namespace elsie::plugin
