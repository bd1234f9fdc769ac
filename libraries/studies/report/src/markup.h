// Text of users and plugins in the report's XML and HTML.
#pragma once

#include <string>
#include <string_view>

#include "elsie/base/utf8.h"
#include "elsie/world/escaped.h"

namespace elsie::report {

/// base::clean(), escaped for text and for attributes in double quotes.
inline std::string escaped(std::string_view text) { return world::escaped(base::clean(text)); }

/// The same for attributes of XML, where line feeds and tabs would become blanks.
inline std::string escaped_attribute(std::string_view text) {
  return world::escaped_attribute(base::clean(text));
}

}  // namespace elsie::report
