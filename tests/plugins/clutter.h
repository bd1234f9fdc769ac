// Discs and boxes, drawn at random between a robot and its place.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "elsie/base/random.h"

namespace elsie::test {

/// The elements of so many obstacles of a world, every other one a box; at least `room_m` between
/// the discs around two of them.
inline std::string clutter(std::uint64_t seed, std::size_t count, double room_m) {
  struct Disc {
    double x, y, radius;
  };
  Random random(seed);
  std::vector<Disc> placed;
  std::string obstacles;
  while (placed.size() < count) {
    const Disc disc{random.uniform(-3, 3), random.uniform(-2.2, 2.2), random.uniform(0.1, 0.35)};
    bool fits = true;
    for (const Disc& other : placed) {
      fits = fits &&
             std::hypot(disc.x - other.x, disc.y - other.y) > disc.radius + other.radius + room_m;
    }
    if (!fits) continue;
    placed.push_back(disc);
    const std::string at =
        " x='" + std::to_string(disc.x) + "' y='" + std::to_string(disc.y) + "' ";
    const std::string side = std::to_string(1.4 * disc.radius);
    obstacles += placed.size() % 2 == 0 ? "<static_cylinder" + at + "radius='" +
                                              std::to_string(disc.radius) + "' height='0.3'/>"
                                        : "<static_box" + at + "heading_deg='" +
                                              std::to_string(random.uniform(0, 90)) + "' length='" +
                                              side + "' width='" + side + "'/>";
  }
  return obstacles;
}

}  // namespace elsie::test
