#include "elsie/world/train.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/world/footprint.h"

namespace elsie::world {
namespace {

/// The angle at which a corner, `half_width` m aside of the joint's line and `back` m behind the
/// joint, reaches a face that lies `front` m before the joint and across the line.
double angle_of_touch(double half_width, double back, double front) {
  const double radius = std::hypot(half_width, back);
  if (front >= radius) return 0.5 * std::numbers::pi;  // it passes
  return std::atan2(back, half_width) + std::asin(front / radius);
}

/// Behind a vehicle whose middle is `place` m behind the robot's.
std::vector<Coupling> behind(Footprint front, double place, std::span<const Segment> segments) {
  std::vector<Coupling> result;
  for (const Segment& segment : segments) {
    const Footprint own = footprint_of(segment, {}, 0.0);
    const double apart = front.half_length + segment.gap + own.half_length;
    Coupling coupling;
    coupling.behind = segment.hitch.value_or(front.half_length + 0.5 * segment.gap);
    coupling.ahead = apart - coupling.behind;
    coupling.height = segment.hitch_height.value_or(segment.wheel_radius);
    const double half_width = std::max(front.half_width, own.half_width);
    const double behind_face = coupling.behind - front.half_length;
    const double ahead_of_face = coupling.ahead - own.half_length;
    const double free =
        std::min({angle_of_touch(half_width, ahead_of_face, behind_face),
                  angle_of_touch(half_width, behind_face, ahead_of_face), 0.5 * std::numbers::pi});
    coupling.max_yaw_rad = segment.max_yaw_deg ? radians(*segment.max_yaw_deg) : free;
    coupling.max_pitch_rad = radians(segment.max_pitch_deg);
    place += apart;
    coupling.place = place;
    result.push_back(coupling);
    front = own;
  }
  return result;
}

}  // namespace

std::vector<Coupling> couplings(const RobotBody& body, std::span<const Segment> segments) {
  return behind(footprint_of(body, {}, 0.0), 0.0, segments);
}

std::vector<Coupling> couplings_behind(const BodyPlan& plan, std::span<const Segment> segments) {
  if (segments.empty()) return {};
  const std::vector<Footprint> own = footprints_of(plan, {}, 0.0);
  return behind(own.back(), -own.back().x, segments);
}

}  // namespace elsie::world
