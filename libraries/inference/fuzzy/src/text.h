// Words and numbers in messages, and names without letter case.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie::fuzzy {

using base::name_in_quotes;
using base::number_text;

/// ASCII letters in lower case, other characters unchanged.
std::string lower(std::string_view text);
std::string upper(std::string_view text);
bool same_name(std::string_view a, std::string_view b);

/// " Did you mean 'x'?" for the nearest candidate; empty if none is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace elsie::fuzzy
