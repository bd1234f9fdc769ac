// The joints between a robot and the segments that it pulls: their places and ranges.
#pragma once

#include <span>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

/// The joint between a segment and the body in front, the robot or another segment.
struct Coupling : HitchJoint {
  double place = 0.0;  // m, of the segment's middle behind the robot's, in a straight train
};

/// One for each segment behind the last vehicle of a body. By default the joint is in the middle of
/// the gap, at the height of the segment's axle, and turns until a corner of one body would reach
/// the face of the other. With the joint b m behind the front body's rear face and f m ahead of the
/// segment's front face, and h half the width of the wider of the two, that is the smallest angle t
/// > 0 for which
///     h sin t - f cos t = b  or  h sin t - b cos t = f,
/// but at most 90 degrees. Behind a round robot it turns until the segment would reach the disc
/// around it.
std::vector<Coupling> couplings(const BodyPlan& plan, std::span<const Segment> segments);

}  // namespace elsie::world
