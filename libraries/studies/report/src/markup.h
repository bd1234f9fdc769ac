// Text inside of the report's XML and HTML: whatever users and plugins have written.
#pragma once

#include <string>
#include <string_view>

#include "elsie/base/utf8.h"
#include "elsie/world/escaped.h"

namespace elsie::report {

/// base::clean(), fit to stand between tags, and between double quotes.
inline std::string escaped(std::string_view text) { return world::escaped(base::clean(text)); }

/// The same for attributes of XML, where line feeds and tabs would become blanks.
inline std::string escaped_attribute(std::string_view text) {
  return world::escaped_attribute(base::clean(text));
}

}  // namespace elsie::report
