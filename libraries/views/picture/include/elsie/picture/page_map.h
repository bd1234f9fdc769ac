// A world from above with the paths of many runs, for an HTML page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie::world {
struct World;
}

namespace elsie::picture {

struct MapPath {
  enum class Kind { plain, missed, odd };

  Kind kind = Kind::plain;      // later ones are drawn over earlier ones
  std::vector<Vector2> points;  // m; those that are not finite interrupt it
  std::string title;            // shown when the pointer is over it
  std::string name{};           // written at its end if there is room
};

/// The world at its start as an element of an HTML page, with the paths, simplified to about
/// `most_points` points in total. The page's style defines the colours of page_chart() and --c,
/// --bad, --good, --floor, --wall and --box. `label`: for readers who do not see it.
std::string page_map(const world::World& world, const std::vector<MapPath>& paths,
                     std::size_t most_points, const std::string& label);

}  // namespace elsie::picture
