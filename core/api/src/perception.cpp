#include "elsie/api/perception.h"

#include <stdexcept>
#include <string>

#include "elsie/base/error.h"

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

void other_layout(const ReadingKind& wanted, const ReadingGroup& made) {
  const std::string difference = wanted.size == made.kind.size
                                     ? " list other fields in visit() than those"
                                     : " have " + std::to_string(wanted.size) + " bytes, not the " +
                                           std::to_string(made.kind.size);
  throw base::Error(std::string("its readings of the kind '").append(wanted.name) + "'" +
                    difference + " of the sensor '" + made.readings.front().sensor +
                    "'; build both plugins with the same header of this kind");
}

}  // namespace elsie::detail
