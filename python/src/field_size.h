// The sizes of numbers in readings.
#pragma once

#include <cstddef>

#include "elsie/api/reading.h"

namespace elsie::python {

/// Bytes of one number. Not for pictures.
constexpr std::size_t size_of(FieldType type) {
  switch (type) {
    case FieldType::boolean:
    case FieldType::int8:
    case FieldType::uint8:
      return 1;
    case FieldType::int16:
    case FieldType::uint16:
      return 2;
    case FieldType::int32:
    case FieldType::uint32:
    case FieldType::real32:
      return 4;
    default:
      return 8;
  }
}

}  // namespace elsie::python
