#include "vehicle.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

// How much further it may come in a step than at its present speed, by being accelerated.
constexpr double kRobotSlack = 1e-3;  // m

}  // namespace

void place_vehicle(Scene& scene, Scene::Id id, const MovingVehicle& vehicle, double step) {
  const Frame& frame = vehicle.frame;
  const OrientedBox& box = vehicle.box;
  const Cylinder& wheel = vehicle.wheels[0];
  OrientedBox sensed = box;
  sensed.center = sensed.center + 0.5 * kSensorDeck * frame.up;
  sensed.half.z += 0.5 * kSensorDeck;
  // From the floor to the deck, and as wide and long as box and wheels together.
  const double above = dot(box.center - frame.origin, frame.up) + box.half.z;
  const double aside = std::abs(dot(wheel.center - frame.origin, frame.left));
  const double top = std::max(above + kSensorDeck, 2.0 * wheel.radius);
  const OrientedBox enclosing{frame.point({0.0, 0.0, 0.5 * top}),
                              box.axes,
                              {std::max(box.half.x, wheel.radius),
                               std::max(box.half.y, aside + wheel.half_length), 0.5 * top}};
  const double size = enclosing.half.x + enclosing.half.y + 2.0 * enclosing.half.z;
  const double speed = std::sqrt(dot(vehicle.velocity, vehicle.velocity)) +
                       size * std::sqrt(dot(vehicle.turning, vehicle.turning));
  scene.place_robot(id, sensed, vehicle.wheels, enclosing, step * speed + kRobotSlack);
}

}  // namespace elsie::physics
