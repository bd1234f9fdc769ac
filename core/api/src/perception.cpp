#include "elsie/api/perception.h"

#include <stdexcept>
#include <string>

namespace elsie::detail {

void no_such_reading(const char* kind, std::size_t i, std::size_t count) {
  const std::string quoted = std::string("'").append(kind) + "'";
  const std::string has = count == 0   ? "no sensor of the robot makes readings of this kind"
                          : count == 1 ? "the robot has one, number 0"
                                       : "the robot has " + std::to_string(count) +
                                             ", numbers 0 to " + std::to_string(count - 1);
  throw std::out_of_range("it asks for reading number " + std::to_string(i) + " of kind " + quoted +
                          ", but " + has +
                          "; ask size() first, or name the kind in the declaration with "
                          "elsie::needs<>()");
}

}  // namespace elsie::detail
