#include "prism.h"

#include <cstddef>

namespace elsie::physics {

OdeGeom make_prism(Corners outline, double half_height, ConvexArrays& arrays) {
  const auto n = static_cast<unsigned>(outline.size());
  // Point 2 i is at the bottom of corner i, and 2 i + 1 at its top.
  for (const Vector2& corner : outline) {
    for (const double z : {-half_height, half_height}) {
      arrays.points.insert(arrays.points.end(), {corner.x, corner.y, z});
    }
  }
  const auto add_plane = [&](double x, double y, double z, double distance) {
    arrays.planes.insert(arrays.planes.end(), {x, y, z, distance});
  };
  for (unsigned i = 0; i < n; ++i) {
    const unsigned next = (i + 1) % n;
    const Side side = side_of(outline, i);
    add_plane(side.normal.x, side.normal.y, 0.0, -side.gap_to({}));
    arrays.faces.insert(arrays.faces.end(), {4, 2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
  }
  add_plane(0.0, 0.0, 1.0, half_height);
  arrays.faces.push_back(n);
  for (unsigned i = 0; i < n; ++i) arrays.faces.push_back(2 * i + 1);
  add_plane(0.0, 0.0, -1.0, half_height);
  arrays.faces.push_back(n);
  for (unsigned i = n; i-- > 0;) arrays.faces.push_back(2 * i);
  return OdeGeom(dCreateConvex(nullptr, arrays.planes.data(), n + 2, arrays.points.data(), 2 * n,
                               arrays.faces.data()));
}

dMass prism_mass(Corners outline, double height, double mass) {
  const OutlineMoments area = moments_of(outline);
  const double upright = height * height / 12.0;
  dMass made;
  dMassSetParameters(&made, mass, 0.0, 0.0, 0.0, mass * (area.yy + upright),
                     mass * (area.xx + upright), mass * (area.xx + area.yy), -mass * area.xy, 0.0,
                     0.0);
  return made;
}

}  // namespace elsie::physics
