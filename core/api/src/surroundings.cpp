#include "elsie/api/surroundings.h"

#include <cmath>

namespace elsie {

Thing Surroundings::thing(const Surface& /*surface*/) const { return {}; }

const OwnState& Surroundings::self() const {
  static const OwnState kUsual;
  return kUsual;
}

Colour Surroundings::floor_colour(const Vector2& /*place*/) const { return {255, 255, 255}; }

void Surroundings::things_within(double /*radius_m*/, std::vector<NearThing>& /*things*/) const {}

bool Surroundings::is_open(const Vector3& from, const Vector3& to) const {
  constexpr double kHair = 1e-6;  // m: a surface at the very place hides nothing
  const Vector3 way = to - from;
  const double length = std::sqrt(dot(way, way));
  return length <= kHair || !cast_ray(from, (1.0 / length) * way, length - kHair);
}

}  // namespace elsie
