// Two parameters that contradict each other, in words.
#pragma once

#include <string>

#include <elsie/base/number_text.h>

/// "margin is 0.5 m and sphere 0.2 m; ": the beginning of a sentence.
inline std::string two_values(const char* name, double value, const char* other_name, double other,
                              const char* unit) {
  using elsie::base::number_text;
  return std::string(name) + " is " + number_text(value, 6) + " " + unit + " and " + other_name +
         " " + number_text(other, 6) + " " + unit + "; ";
}
