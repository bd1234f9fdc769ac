// A world as lists of shapes. Only this module computes where walls stand and where wheels are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/drive.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// A fixed thing in the arena.
struct Fixture {
  enum class Kind : std::uint8_t { wall, obstacle, charger };

  Kind kind = Kind::wall;
  /// Its index in the world's boxes or chargers; walls: 0 east (+x), 1 north (+y), 2 west, 3 south.
  std::size_t index = 0;
  Shape shape;  // a disc without height for a charger that range sensors do not see
  Frame frame;  // of its middle, at the start
};

/// The walls, which stand outside of the arena's area. Those along x are long enough to close the
/// corners. Empty if the arena has no walls.
std::vector<Fixture> walls_of(const Arena& arena);
Fixture fixture_of(const Obstacle& obstacle, std::size_t index = 0);
Fixture fixture_of(const Charger& charger, std::size_t index = 0);
/// What is wrong with the attributes of its shape, to follow its name: "is not convex: ...".
std::optional<std::string> problem_of(const Obstacle& obstacle);

/// The data about a body that its drive receives.
Chassis chassis_of(const RobotBody& body);
/// Calls Drive::build() and returns the chassis with the parts of the drive. Throws what the drive
/// throws, and as check() does.
BodyPlan plan_of(const Chassis& chassis, Drive& drive);

/// The joint between a segment and the body in front, the robot or another segment.
struct Coupling : HitchJoint {
  double place = 0.0;  // m, from the robot's middle back to the segment's, in a straight train
};

/// The couplings of the segments behind the last vehicle of a body. By default the joint is in the
/// middle of the gap, at the height of the segment's axle, and turns until a corner of one body
/// would reach the face of the other. Let the joint be b m behind the front body's rear face and
/// f m ahead of the segment's front face, and let h be half the width of the wider body. Then the
/// limit is the smallest angle t > 0 for which
///     h sin t - f cos t = b  or  h sin t - b cos t = f,
/// but at most 90 degrees. Behind a round robot, the joint turns until the segment would reach the
/// disc around the robot.
std::vector<Coupling> couplings(const BodyPlan& plan, std::span<const Segment> segments);

/// The parts of a robot and of its segments, which are its last vehicles. A robot whose drive has
/// not built its parts yet (Robot::driven is empty) has the default drive.
BodyPlan plan_of(const RobotBody& body, std::span<const Segment> segments);
BodyPlan plan_of(const Robot& robot);
/// The parts of a robot without its segments.
BodyPlan driven_plan(const Robot& robot);
/// The parts of a single segment.
std::vector<Part> parts_of(const Segment& segment);
/// Throws std::invalid_argument with a sentence about the first impossible property of a body:
/// wheels inside each other, a part below the floor...
void check(const BodyPlan& plan);
/// The frames of a body's vehicles in the robot's frame, when they stand in line.
std::vector<Frame> in_line(const BodyPlan& plan);
/// The parts of one of a body's vehicles, the chassis first.
std::span<const Part> vehicle_of(const BodyPlan& plan, std::size_t vehicle);

/// The largest extents of a part from its middle along the axes of its vehicle's frame, m. Those of
/// a steered wheel cover every steering angle.
Vector3 reach_of(const Part& part);
/// The largest distance of a part with this middle from the origin, seen from above, m.
double farthest_of(const Part& part, const Vector3& middle);

}  // namespace elsie::world
