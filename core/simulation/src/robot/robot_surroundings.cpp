#include "robot/robot_surroundings.h"

namespace elsie::simulation {
namespace {

Surface surface_of(const physics::Body& body, const Vector3& normal) {
  switch (body.kind) {
    case physics::BodyKind::robot:
      return {Surface::Kind::robot, body.index, normal};
    case physics::BodyKind::obstacle:
      return {Surface::Kind::obstacle, body.index, normal};
    case physics::BodyKind::wall:
      break;
  }
  return {Surface::Kind::wall, body.index, normal};
}

}  // namespace

std::vector<Contact> RobotSurroundings::contacts() const {
  std::vector<Contact> contacts;
  if (!robots_[robot_]->watched().contacts) return contacts;
  for (const physics::BodyContact& each : engine_.contacts(robot_)) {
    contacts.push_back({each.vehicle, surface_of(each.other, each.normal), each.point, each.normal,
                        each.pressing()});
  }
  return contacts;
}

BodyMotion RobotSurroundings::motion() const {
  const physics::Motion motion = engine_.motion(robot_);
  return {motion.velocity, motion.turning, motion.acceleration, motion.turning_acceleration};
}

}  // namespace elsie::simulation
