// A solid as range and proximity sensors meet it. Inline, as the ray tests are.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "elsie/shapes/shape.h"

#include "pyramid_test.h"
#include "ray_tests.h"

namespace elsie::physics {

struct SensedSolid {
  Shape::Kind kind = Shape::Kind::box;
  Shape::Axis axis = Shape::Axis::up;
  OrientedBox box;                 // around it
  Cylinder round;                  // around a cylinder, capsule or sphere
  std::vector<Vector2> outline{};  // of a prism

  SensedSolid() = default;
  explicit SensedSolid(const Shape& shape)
      : kind(shape.kind), axis(shape.axis), outline(shape.outline) {
    round.radius = shape.radius();
  }
  void put(const OrientedBox& around) {
    box = around;
    const std::array halves{box.half.x, box.half.y, box.half.z};
    const auto along = static_cast<std::size_t>(axis);
    round = {box.center, box.axes[along], round.radius, halves[along]};
  }
};

/// The box around a chassis of this shape with the sensor deck on its level top.
inline OrientedBox with_deck(const Shape& shape, OrientedBox box) {
  if (!shape.has_level_top()) return box;
  box.center = box.center + 0.5 * kSensorDeck * box.axes[2];
  box.half.z += 0.5 * kSensorDeck;
  return box;
}

/// Distance at which the ray enters the solid, or kMiss.
inline double distance_to(const Ray& ray, const SensedSolid& solid) {
  switch (solid.kind) {
    case Shape::Kind::box:
      return distance_to_box(ray, solid.box);
    case Shape::Kind::prism:
      return distance_to_prism(ray, solid.box, solid.outline);
    case Shape::Kind::cylinder:
      return distance_to_cylinder(ray, solid.round);
    default:
      return distance_to_capsule(ray, solid.round);
  }
}

/// The same for a chassis with wheels, whose highest point is at `wheels_top`.
inline double distance_to(const Ray& ray, const SensedSolid& chassis,
                          const std::vector<Cylinder>& wheels, double wheels_top) {
  double nearest = distance_to(ray, chassis);
  // Most beams are level and above the wheels.
  if (ray.direction.z < 0.0 || ray.origin.z <= wheels_top) {
    for (const Cylinder& wheel : wheels) {
      nearest = std::min(nearest, distance_to_cylinder(ray, wheel));
    }
  }
  return nearest;
}

/// Whether the solid, or the box around a ball or capsule, reaches into the pyramid.
inline bool is_in(const PyramidTest& pyramid, const SensedSolid& solid) {
  return solid.kind == Shape::Kind::cylinder ? pyramid.meets(solid.round)
         : solid.kind == Shape::Kind::prism  ? pyramid.meets(solid.box, solid.outline)
                                             : pyramid.meets(solid.box);
}

}  // namespace elsie::physics
