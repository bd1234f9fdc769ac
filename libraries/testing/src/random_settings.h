#pragma once

#include <string>

#include "elsie/testing/plugins.h"

namespace elsie::testing {

/// Values for about half of the parameters, within their declared ranges and at the bounds, too;
/// `fixed` is always included. Files, and texts without choices, keep their defaults.
Settings random_settings(const Declaration& declaration, const Settings& fixed, Random& random);

/// "speed = 3 and side = left", or "its defaults".
std::string in_words(const Settings& settings);

}  // namespace elsie::testing
