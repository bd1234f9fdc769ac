#include "text.h"

#include <cctype>
#include <cstdlib>
#include <exception>
#include <memory>
#include <typeinfo>

#include <cxxabi.h>

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

std::string demangled(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t length = 0;
    while (length < text.size() && is_symbol_character(text[length])) {
      ++length;
    }
    if (length == 0) {
      result += text.front();
      text.remove_prefix(1);
      continue;
    }
    const std::string word(text.substr(0, length));
    result += word.starts_with("_Z") ? demangled_name(word) : word;
    text.remove_prefix(length);
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
