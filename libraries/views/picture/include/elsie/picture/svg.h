// SVG as text: numbers, colours and path data.
#pragma once

#include <span>
#include <string>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

namespace elsie::picture {

/// At most `decimals` decimals, the same in every locale: "0.25", "3"; never "-0".
std::string short_number(double value, int decimals);

/// "#d0311e"
std::string hex_text(const Colour& colour);

/// The data of a path: "M10 20l3-4 5 6z". Coordinates are rounded; steps that vanish are left out.
std::string path_data(std::span<const Vector2> line, int decimals = 0, bool closed = false);

}  // namespace elsie::picture
