// Text inside of XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace elsie::world {

/// The text between two tags: & < > and " are replaced. What may stand in no XML, see clean(), is
/// left as it is.
std::string escaped(std::string_view text);

/// The text as an attribute's value between double quotes: escaped(), with tabs and ends of lines
/// replaced, too, which a reader would take for blanks.
std::string escaped_attribute(std::string_view text);

}  // namespace elsie::world
