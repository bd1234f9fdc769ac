// Parts of sentences.
#pragma once

#include <string>

#include "elsie/base/number_text.h"

namespace elsie::testing {

using base::number_text;

/// To be called in a catch block: what was thrown, and where, if that is known.
std::string thrown_text();

/// "40.1 MB".
std::string in_bytes(double bytes);

}  // namespace elsie::testing
