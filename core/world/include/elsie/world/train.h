// A robot and what it pulls, as a chain: where the joints are and how far they turn.
#pragma once

#include <span>
#include <vector>

#include "elsie/world/description.h"

namespace elsie::world {

/// How a segment hangs on the body in front of it: the robot, or the segment before. The joint has
/// two degrees of freedom: yaw about the front body's vertical axis, pitch about the segment's
/// transverse one.
struct Coupling {
  double behind = 0.0;         // m, of the joint behind the middle of the body in front
  double ahead = 0.0;          // m, of the joint ahead of the segment's middle
  double height = 0.0;         // m, of the joint above the floor
  double max_yaw_rad = 0.0;    // to either side
  double max_pitch_rad = 0.0;  // upwards and downwards
  double place = 0.0;  // m, of the segment's middle behind the robot's, when all stand in line
};

/// One for each segment. Unless a segment says otherwise its joint is in the middle of the gap, at
/// the height of its axle, and turns until a corner of one body would reach the face of the other.
/// With the joint b m behind the front body's rear face and f m ahead of the segment's front face,
/// and h half the width of the wider of the two, that is the smallest angle t > 0 for which
///     h sin t - f cos t = b  or  h sin t - b cos t = f,
/// but at most 90 degrees.
std::vector<Coupling> couplings(const RobotBody& body, std::span<const Segment> segments);

}  // namespace elsie::world
