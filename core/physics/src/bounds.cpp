#include "bounds.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "elsie/world/train.h"

namespace elsie::physics {
namespace {

constexpr double kCorrections = 2.0;  // m/s: of several that are put apart, one after the other

}  // namespace

void Bounds::add_height(double top) { top_ = std::max(top_, top); }
void Bounds::add_robot_speed(double speed) { robot_ = std::max(robot_, speed); }
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

double lever_of(const world::RobotBody& body, std::span<const world::Segment> segments) {
  double reach = std::max(std::hypot(0.5 * body.length, 0.5 * body.width),
                          std::hypot(body.wheel_radius, body.half_axle() + 0.5 * body.wheel_width));
  const std::vector<world::Coupling> chain = world::couplings(body, segments);
  double behind = 0.0;
  for (std::size_t i = 0; i < chain.size(); ++i) {
    behind += chain[i].behind + chain[i].ahead;
    const world::Segment& segment = segments[i];
    const double corner =
        std::hypot(std::max(0.5 * segment.length, segment.wheel_radius), 0.5 * segment.width);
    reach = std::max({reach, behind + corner});
  }
  return std::max(1.0, reach / body.half_axle());
}

}  // namespace elsie::physics
