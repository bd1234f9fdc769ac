// A world as lists of shapes: the only place that knows where a wall stands and where a wheel is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/drive.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// Something that stands in the arena.
struct Fixture {
  enum class Kind : std::uint8_t { wall, box, charger };

  Kind kind = Kind::wall;
  /// In the world's boxes or chargers; of a wall: 0 east (+x), 1 north (+y), 2 west, 3 south.
  std::size_t index = 0;
  Shape shape;  // a charger that range sensors do not see is a disc without height
  Frame frame;  // of its middle, at the start
};

/// The walls, outside of the arena's area; those along x are long enough to close the corners.
/// Empty: the arena has none.
std::vector<Fixture> walls_of(const Arena& arena);
Fixture fixture_of(const Box& box, std::size_t index = 0);
Fixture fixture_of(const Charger& charger, std::size_t index = 0);

/// What a drive gets to know of a body.
Chassis chassis_of(const RobotBody& body);
/// The chassis on the parts of a drive, which is built by this. Throws what the drive throws, and
/// as check() does.
BodyPlan plan_of(const Chassis& chassis, Drive& drive);

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

/// The parts of a robot and of the segments that it pulls, which are its last vehicles. A robot
/// whose drive has not been asked (Robot::driven) has the default one.
BodyPlan plan_of(const RobotBody& body, std::span<const Segment> segments);
BodyPlan plan_of(const Robot& robot);
/// Without the segments.
BodyPlan driven_plan(const Robot& robot);
/// The parts of a segment that stands by itself.
std::vector<Part> parts_of(const Segment& segment);
/// Throws std::invalid_argument with a sentence about the first thing that no body can be: wheels
/// inside each other, a part below the floor...
void check(const BodyPlan& plan);
/// The frames of a body's vehicles in the robot's, in line behind each other.
std::vector<Frame> in_line(const BodyPlan& plan);
/// The parts of one of a body's vehicles, the chassis first.
std::span<const Part> vehicle_of(const BodyPlan& plan, std::size_t vehicle);

/// How far a part reaches from its middle along the axes of its vehicle's frame, m; a wheel that is
/// steered, wherever it points.
Vector3 reach_of(const Part& part);
/// How far a part reaches from the origin, m, seen from above, when its middle is there.
double farthest_of(const Part& part, const Vector3& middle);

}  // namespace elsie::world
