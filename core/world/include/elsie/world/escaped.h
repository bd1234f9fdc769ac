// Text in XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace elsie::world {

/// Text for between two tags: & < > and " are replaced. Characters that XML does not allow
/// stay.
std::string escaped(std::string_view text);

/// Text for an attribute in double quotes: escaped(), also with tabs and line ends replaced, which
/// XML would read as blanks.
std::string escaped_attribute(std::string_view text);

}  // namespace elsie::world
