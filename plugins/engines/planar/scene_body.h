// A body in the scene of the planar engine.
#pragma once

#include <algorithm>
#include <cstdint>

#include "elsie/api/geometry.h"
#include "elsie/physics/engine.h"

#include "plane.h"

namespace elsie::physics {

inline constexpr double kHair = 1e-9;  // m, so that rounding never hides a body

/// What the frequent queries need of a body, without its wheels: an upright box, or the circle
/// around something else. In two lines of the processor's cache: what tells whether it is near, and
/// the rest.
struct alignas(64) SceneBody {
  /// Its horizontal section, if rays that run level above its wheels need no more of its shape.
  enum class Section : std::uint8_t { box, disc, other };

  Vector2 place;
  Direction ahead;
  Vector2 half;
  double reach = 0.0;       // m, the radius of the circle around it
  std::uint32_t index = 0;  // among its kind
  BodyKind kind = BodyKind::wall;
  Section section = Section::box;
  bool sensed : 1 = false;
  bool placed : 1 = false;
  bool moves : 1 = false;

  double low = 0.0, high = 0.0;  // m
  double wheels_top = -1.0;      // m; negative: no wheels
  Vector2 least, most;           // the places that have its block of the grid

  Body body() const { return {kind, index}; }
  // Of all of it, m:
  double bottom() const { return wheels_top < 0.0 ? low - kHair : -kHair; }
  double top() const { return std::max(high, wheels_top) + kHair; }
};
static_assert(sizeof(SceneBody) == 128);

}  // namespace elsie::physics
