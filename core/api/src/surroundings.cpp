#include "elsie/api/surroundings.h"

#include <cmath>

namespace elsie {

bool Surroundings::is_open(const Vector3& from, const Vector3& to) const {
  constexpr double kHair = 1e-6;  // m: a surface at the very place hides nothing
  const Vector3 way = to - from;
  const double length = std::sqrt(dot(way, way));
  return length <= kHair || !cast_ray(from, (1.0 / length) * way, length - kHair);
}

}  // namespace elsie
