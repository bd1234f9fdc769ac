#include "sensor_shape.h"

#include <algorithm>
#include <variant>

#include "elsie/world/parts.h"

#include "outline.h"

namespace elsie::physics {
namespace {

SensorShape shape_with_reach(const Shape& shape, const OrientedBox& box, double reach) {
  SensorShape sensor_shape;
  sensor_shape.solid = SensedSolid(shape);
  sensor_shape.solid.put(box);
  sensor_shape.reach = reach;
  return sensor_shape;
}

/// An upright box of this size around a place above the origin.
OrientedBox upright_box(const Vector3& size, double bottom) {
  return {{0.0, 0.0, bottom + 0.5 * size.z}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0.5 * size};
}

}  // namespace

SensorShape SensorShape::of(const Shape& shape, double bottom) {
  return shape_with_reach(shape, upright_box(shape.size, bottom), Outline::of(shape, 0.0).reach);
}

SensorShape SensorShape::of(std::span<const Part> vehicle) {
  const Part& chassis = vehicle.front();
  const Shape& shape = chassis.shape;
  const double bottom = chassis.frame.origin.z - 0.5 * shape.size.z;
  SensorShape sensor_shape =
      shape_with_reach(shape, with_deck(shape, upright_box(shape.size, bottom)),
                       world::farthest_of(chassis, chassis.frame.origin));
  for (const Part& part : vehicle) {
    if (!std::holds_alternative<WheelJoint>(part.joint)) continue;
    const double radius = part.shape.radius();
    sensor_shape.wheels.push_back(
        {part.frame.origin, part.frame.left, radius, 0.5 * part.shape.length()});
    sensor_shape.wheels_top = std::max(sensor_shape.wheels_top, part.frame.origin.z + radius);
    sensor_shape.reach = std::max(sensor_shape.reach, world::farthest_of(part, part.frame.origin));
  }
  return sensor_shape;
}

}  // namespace elsie::physics
