#include "text.h"

#include <cmath>
#include <exception>

namespace elsie::testing {

std::string caught_text() {
  try {
    throw;
  } catch (const std::exception& error) {
    return error.what();
  } catch (...) {
    return "something that is no std::exception";
  }
}

std::string in_bytes(double bytes) {
  const auto rounded = [](double value) { return number_text(std::round(10.0 * value) / 10.0); };
  return bytes < 1e4   ? number_text(std::round(bytes)) + " bytes"
         : bytes < 1e6 ? rounded(bytes / 1e3) + " kB"
                       : rounded(bytes / 1e6) + " MB";
}

}  // namespace elsie::testing
