#include "text.h"

#include <cmath>

#include "elsie/base/thrown.h"

namespace elsie::testing {

std::string thrown_text() {
  const std::string place = base::place_of_throw();
  return base::what_was_thrown() + (place.empty() ? "" : "; thrown in " + place);
}

std::string in_bytes(double bytes) {
  const auto rounded = [](double value) { return number_text(std::round(10.0 * value) / 10.0); };
  return bytes < 1e4   ? number_text(std::round(bytes)) + " bytes"
         : bytes < 1e6 ? rounded(bytes / 1e3) + " kB"
                       : rounded(bytes / 1e6) + " MB";
}

}  // namespace elsie::testing
