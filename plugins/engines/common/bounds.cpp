#include "bounds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <vector>

#include "elsie/world/parts.h"

namespace elsie::physics {
namespace {

constexpr double kCorrections = 2.0;  // m/s: of several bodies that are pushed apart in a row

}  // namespace

void Bounds::add(const Bounds& other) {
  add_height(other.top_);
  // A fall that began under the earlier gravity may go on for a while.
  const double fall = std::sqrt(2.0 * std::abs(other.physics_.gravity) * other.top_);
  add_robot_speed(other.robot_ + (other.physics_.gravity == physics_.gravity ? 0.0 : fall));
  add_moving_speed(other.moving_);
}

void Bounds::add_height(double top) { top_ = std::max(top_, top); }
void Bounds::add_robot_speed(double speed) {
  const std::atomic_ref<double> robot(robot_);
  double known = robot.load(std::memory_order_relaxed);
  while (speed > known && !robot.compare_exchange_weak(known, speed, std::memory_order_relaxed)) {
  }
}
void Bounds::add_moving_speed(double speed) { moving_ = std::max(moving_, speed); }

double Bounds::most_speed() const {
  const double fall = std::sqrt(2.0 * std::abs(physics_.gravity) * top_);
  return 2.0 * (1.0 + physics_.bounce) * (robot_ + moving_) + fall + kCorrections;
}

bool Bounds::within_walls(const Vector3& place) const {
  return arena_.walls && std::abs(place.x) <= 0.5 * arena_.length &&
         std::abs(place.y) <= 0.5 * arena_.width;
}

std::optional<Failure> Bounds::check(const Vector3& middle, const Vector3& velocity,
                                     bool stays_within) const {
  Failure failure;
  failure.place = middle;
  const double square = dot(velocity, velocity);
  if (!std::isfinite(square + middle.x + middle.y + middle.z)) {
    failure.kind = Failure::Kind::not_finite;
    return failure;
  }
  failure.speed = std::sqrt(square);
  failure.limit = most_speed();
  if (failure.speed > failure.limit) {
    failure.kind = Failure::Kind::too_fast;
  } else if (middle.z < 0.0) {
    failure.kind = Failure::Kind::below_floor;
  } else if (stays_within && !within_walls(middle)) {
    failure.kind = Failure::Kind::outside;
  } else {
    return std::nullopt;
  }
  return failure;
}

double lever_of(const BodyPlan& plan) {
  const std::vector<Frame> frames = world::in_line(plan);
  double reach = 0.0, nearest = std::numeric_limits<double>::infinity();
  for (const Part& part : plan.parts) {
    const Vector3 at = frames[part.vehicle].point(part.frame.origin);
    reach = std::max(reach, world::farthest_of(part, at));
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    if (wheel && wheel->torque > 0.0) nearest = std::min(nearest, std::hypot(at.x, at.y));
  }
  return std::max(1.0, reach / nearest);
}

}  // namespace elsie::physics
