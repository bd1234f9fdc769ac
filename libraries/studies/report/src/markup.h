// Escapes text of users and plugins in the report's XML and HTML.
#pragma once

#include <string>
#include <string_view>

#include "elsie/files/clean_text.h"
#include "elsie/world/escaped.h"

namespace elsie::report {

/// files::clean(), escaped for text and for attributes in double quotes.
inline std::string escaped(std::string_view text) { return world::escaped(files::clean(text)); }

/// The same for attributes of XML, where line feeds and tabs would become blanks.
inline std::string escaped_attribute(std::string_view text) {
  return world::escaped_attribute(files::clean(text));
}

}  // namespace elsie::report
