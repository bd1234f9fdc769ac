// The joints between a robot and the segments that it pulls.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/world/footprint.h"
#include "elsie/world/parts.h"

namespace elsie::world {
namespace {

/// The angle at which a corner, `half_width` m to the side of the joint's line and `back` m behind
/// the joint, reaches a face across the line that is `front` m ahead of the joint.
double angle_of_touch(double half_width, double back, double front) {
  const double radius = std::hypot(half_width, back);
  if (front >= radius) return 0.5 * std::numbers::pi;  // the corner passes the face
  return std::atan2(back, half_width) + std::asin(front / radius);
}

/// The same for a disc in front, whose middle is `middle` m ahead of the joint. The corner is one
/// of a face `back` m behind the joint. The disc may also touch that face between its corners.
double angle_of_touch_with_disc(double radius, double middle, double half_width, double back) {
  const double square_angle = 0.5 * std::numbers::pi;
  const double reach = std::hypot(half_width, back);
  // The angle at which the corner is on the disc's edge, by the law of cosines.
  const double at_corner =
      (radius * radius - middle * middle - reach * reach) / (2.0 * middle * reach);
  double angle = at_corner > -1.0
                     ? std::acos(std::min(at_corner, 1.0)) - std::atan2(half_width, back)
                     : square_angle;
  const double at_face = (radius - back) / middle;
  if (std::abs(at_face) < 1.0) {
    const double tangent = std::acos(at_face);
    if (middle * std::sin(tangent) <= half_width) angle = std::min(angle, tangent);
  }
  return std::clamp(angle, 0.0, square_angle);
}

/// The angle by which the two bodies can turn against each other until they touch.
double free_angle(const Coupling& joint, const Vector3& front, double front_radius,
                  const Vector3& own) {
  const double ahead_of_face = joint.ahead - own.x;
  if (front_radius > 0.0) {
    // The wheels may extend further to the sides than the distance to the segment.
    front_radius = std::min(front_radius, joint.behind + ahead_of_face);
    return angle_of_touch_with_disc(front_radius, joint.behind, own.y, ahead_of_face);
  }
  const double half_width = std::max(front.y, own.y);
  const double behind_face = joint.behind - front.x;
  return std::min({angle_of_touch(half_width, ahead_of_face, behind_face),
                   angle_of_touch(half_width, behind_face, ahead_of_face), 0.5 * std::numbers::pi});
}

}  // namespace

std::vector<Coupling> couplings(const BodyPlan& plan, std::span<const Segment> segments) {
  if (segments.empty()) return {};
  std::vector<Coupling> result;
  const std::span<const Part> last = vehicle_of(plan, plan.vehicles() - 1);
  Vector3 front = extents_of(last);
  double front_radius = radius_of(last);
  double place = -in_line(plan).back().origin.x;
  for (const Segment& segment : segments) {
    const Vector3 own = extents_of(parts_of(segment));
    const double apart = front.x + segment.gap + own.x;
    Coupling coupling;
    coupling.behind = segment.hitch.value_or(front.x + 0.5 * segment.gap);
    coupling.ahead = apart - coupling.behind;
    coupling.height = segment.hitch_height.value_or(segment.wheel_radius);
    const double free = free_angle(coupling, front, front_radius, own);
    coupling.max_yaw_rad = segment.max_yaw_deg ? radians(*segment.max_yaw_deg) : free;
    coupling.max_pitch_rad = radians(segment.max_pitch_deg);
    place += apart;
    coupling.place = place;
    result.push_back(coupling);
    front = own;
    front_radius = 0.0;
  }
  return result;
}

}  // namespace elsie::world
