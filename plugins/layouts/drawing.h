// What all kinds of layouts share: the world's tree, to which they add elements, its arena, and
// streams of random numbers.
#pragma once

#include <cstdint>
#include <string>

#include "elsie/base/problems.h"
#include "elsie/base/random.h"
#include "elsie/world/layouts.h"

namespace elsie::layouts {

using base::Location;
using base::Problems;
using world::Element;

/// A length or coordinate as it is written into the world: to a tenth of a millimetre, so that the
/// last bits of sines and logarithms do not count.
double rounded_m(double metres);
/// An angle likewise, to a hundredth of a degree, in [-180, 180].
double rounded_deg(double degrees);

/// A whole number in [0, count).
std::size_t drawn_index(Random& random, std::size_t count);

/// A rectangle along the axes, m.
struct Area {
  double x = 0.0, y = 0.0, length = 0.0, width = 0.0;

  double left() const { return x - 0.5 * length; }
  double bottom() const { return y - 0.5 * width; }
  /// Smaller by a margin on each side, m.
  Area shrunk(double margin) const { return {x, y, length - 2.0 * margin, width - 2.0 * margin}; }
};

/// A wall from one point to another, m.
struct Wall {
  double x1 = 0.0, y1 = 0.0, x2 = 0.0, y2 = 0.0;
};

/// The list of the world that an element belongs to; null if the element cannot be scattered.
const char* list_of(const std::string& name);
/// Whether such a thing has a heading.
bool has_heading(const std::string& name);

struct Drawing {
  Element& world;
  std::uint64_t seed;
  const std::string& file;
  const plugin::Host& host;
  const world::Files& files;
  const world::ReadOptions& options;
  Problems& problems;
  world::Arena arena{};
  const Element* layout = nullptr;  // what is being drawn

  /// A separate stream of random numbers, "layouts/clutter/7".
  Random stream(const std::string& path) const { return Random(seed, "layouts/" + path); }

  /// Reports a mistake of the layout; returns false.
  bool refuse(const Location& where, const std::string& id, const std::string& problem);
  /// Returns whether the area is inside of the arena; if not, adds a problem.
  bool require_inside(const Area& area, const Location& where, const std::string& id);

  /// Adds an element to a list of the world, which is made if it is missing. The element's `object`
  /// becomes that of the layout which draws it.
  void add(const std::string& list, Element element);
  /// Adds a static box that is a wall from one point to another. Its ends are long enough to close
  /// corners.
  void add_wall(const std::string& id, const Wall& wall, double thickness, double height,
                const Location& where);
  void add_obstacle(const std::string& id, const Area& area, double heading_deg, double height,
                    const Location& where);
};

}  // namespace elsie::layouts
