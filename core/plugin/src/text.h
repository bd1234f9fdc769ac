// Pieces of sentences.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace elsie::plugin {

/// The shortest decimal text that reads back as the same number.
std::string number_text(double value);

/// "a", "a and b", "a, b and c".
std::string enumeration(const std::vector<std::string>& items);

/// The items with a separator between them.
std::string joined(const std::vector<std::string>& items, std::string_view separator);

/// The text with every mangled C++ name (_Z...) in it made readable.
std::string demangled(std::string_view text);

/// To be called in a catch block: what() of the exception, or its type when it is no
/// std::exception. A copy, which may outlive the library that the exception comes from.
std::string current_exception_text();

}  // namespace elsie::plugin
