// Pictures as arrays of numpy.
#pragma once

#include <algorithm>
#include <cstdint>

#include <pybind11/numpy.h>

#include "elsie/api/image.h"

namespace elsie::python {

/// A copy: rows, columns, channels. An empty picture has no rows.
inline pybind11::array_t<std::uint8_t> array_of(const Image& image) {
  pybind11::array_t<std::uint8_t> array(
      {image.empty() ? 0 : image.height, image.width, image.channels});
  std::copy(image.bytes.begin(), image.bytes.end(), array.mutable_data());
  return array;
}

}  // namespace elsie::python
