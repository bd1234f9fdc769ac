#include "vehicle.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

// The additional distance that it may move in a step because it is accelerated.
constexpr double kRobotSlack = 1e-3;  // m

}  // namespace

bool place_vehicle(Scene& scene, Scene::Id id, const Shape& shape, const Vector3& middle,
                   const std::vector<Cylinder>& wheels, const VehicleMotion& motion, double step) {
  const Frame& frame = motion.frame;
  const OrientedBox chassis{middle, {frame.forward, frame.left, frame.up}, 0.5 * shape.size};
  // From the floor to the deck, as wide and long as chassis and wheels together.
  double top = dot(chassis.center - frame.origin, frame.up) + chassis.half.z + kSensorDeck;
  double half_length = chassis.half.x, half_width = chassis.half.y;
  double radius = shape.radius();  // of a round chassis
  for (const Cylinder& wheel : wheels) {
    const Vector3 at = wheel.center - frame.origin;
    const double along = std::abs(dot(wheel.axis, frame.forward));  // 0: it rolls straight ahead
    const double ahead = along == 0.0 ? wheel.radius : wheel.radius + along * wheel.half_length;
    const double aside =
        along == 0.0 ? wheel.half_length : wheel.half_length + along * wheel.radius;
    const double front = std::abs(dot(at, frame.forward)) + ahead;
    const double side = std::abs(dot(at, frame.left)) + aside;
    half_length = std::max(half_length, front);
    half_width = std::max(half_width, side);
    if (shape.is_round()) radius = std::max(radius, std::hypot(front, side));
    top = std::max(top, 2.0 * wheel.radius);
  }
  const Vector3 half{half_length, half_width, 0.5 * top};
  const Vector3 center = frame.point({0.0, 0.0, half.z});
  const Aabb enclosing = shape.is_round() ? bounds(Cylinder{center, frame.up, radius, half.z})
                                          : bounds(OrientedBox{center, chassis.axes, half});
  const double size = half.x + half.y + 2.0 * half.z;
  const double speed = std::sqrt(dot(motion.velocity, motion.velocity)) +
                       size * std::sqrt(dot(motion.turning, motion.turning));
  SensedSolid sensed(shape);
  sensed.put(with_deck(shape, chassis));
  return scene.place_robot(id, sensed, wheels, enclosing, step * speed + kRobotSlack);
}

}  // namespace elsie::physics
