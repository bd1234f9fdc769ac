// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace elsie::world {

/// Escapes a text that stands between two tags: replaces & < > and ". Characters that XML does not
/// allow remain.
std::string escaped(std::string_view text);

/// Escapes an attribute's value in double quotes: like escaped(), but also replaces tabs and line
/// ends, which XML would read as blanks.
std::string escaped_attribute(std::string_view text);

}  // namespace elsie::world
