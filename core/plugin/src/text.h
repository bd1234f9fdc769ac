// Pieces of sentences.
#pragma once

#include <string>
#include <string_view>

#include "elsie/api/declaration.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie::plugin {

using base::joined;
using base::name_in_quotes;
using base::number_text;

/// "behavior 'wander'".
std::string title(PluginKind kind, std::string_view name);

/// The text with every mangled C++ name (_Z...) in it made readable.
std::string demangled(std::string_view text);

/// Call this in a catch block: returns what() of the exception, or its type when it is not a
/// std::exception. The copy may outlive the library that threw the exception.
std::string current_exception_text();

}  // namespace elsie::plugin
