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

}  // namespace elsie::plugin
