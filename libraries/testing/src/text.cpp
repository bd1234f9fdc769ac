#include "text.h"

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

}  // namespace elsie::testing
