// Text inside of XML and HTML.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace elsie::report {

/// What is no UTF-8, and control characters but tabs and line feeds, replaced by U+FFFD: neither
/// may stand in XML in any form.
std::string clean(std::string_view text);

/// clean(), with the characters that mean something in markup replaced: between tags, and between
/// double quotes.
std::string escaped(std::string_view text);
/// The same for attributes of XML, where line feeds and tabs would become blanks.
std::string escaped_attribute(std::string_view text);

/// The number of characters of UTF-8.
std::size_t characters(std::string_view text);

/// At most so many characters of clean(text), of which an ellipsis in the middle is one when some
/// had to go.
std::string shortened(std::string_view text, std::size_t most);

}  // namespace elsie::report
