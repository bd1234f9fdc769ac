// The places of the bodies of a world, so that scattered things keep their distance.
#pragma once

#include <vector>

#include "elsie/base/grid.h"
#include "elsie/world/footprint.h"

#include "drawing.h"

namespace elsie::layouts {

using world::Footprint;

/// The areas of a thing that stands at the origin, facing along x: one, or one for each vehicle of
/// a train.
using Body = std::vector<Footprint>;

/// The area on the floor, m2.
double covered(const Body& body);
/// The body at another place.
Body moved(const Body& body, double x, double y, double heading_deg);

/// The bodies of robots, boxes, chargers and lamps, and the areas of patches, in the order given,
/// wherever they are. `list` is the group of the world that they belong to. Empty if one of them is
/// invalid; `problems` then gets all mistakes.
std::vector<Body> bodies_of(const Drawing& drawing, const std::string& list,
                            std::vector<Element> things, Problems& problems);

class Occupied {
 public:
  explicit Occupied(const world::Arena& arena) : arena_(arena), grid_(arena.length, arena.width) {}

  /// Adds everything in the world. Returns false, and adds problems, if something in it is invalid.
  bool add_world(const Drawing& drawing);
  void add(const Body& body);
  /// Whether a body keeps at least `gap` m from everything, walls included. Next to the corner of a
  /// body it may have to keep a little more, 1.4 times the gap at most.
  bool has_room_for(const Body& body, double gap) const;

 private:
  base::Grid::Block cells(const Footprint& area) const;

  world::Arena arena_;
  base::Grid grid_;
  std::vector<Footprint> there_;
};

}  // namespace elsie::layouts
