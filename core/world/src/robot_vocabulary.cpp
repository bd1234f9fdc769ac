// The part of the vocabulary about robots.
#include "elsie/world/facts.h"

namespace elsie::world {

namespace {

ElementSpec body() {
  return Describe<RobotBody>("body", "A chassis and the wheels that its drive puts below it")
      .costs(Cost::body)
      .choice("shape", &RobotBody::round,
              {.choices = {"box", "round"},
               .meaning = "of the chassis; a round one has equal length and width"},
              "round")
      .attribute("length", &RobotBody::length, size("chassis, along the heading", 10))
      .attribute("width", &RobotBody::width, size("chassis, across", 10))
      .attribute("height", &RobotBody::height, size("chassis", 10))
      .attribute("clearance", &RobotBody::clearance, size("from the floor to the chassis", 10))
      .attribute("wheel_radius", &RobotBody::wheel_radius, size("radius of the wheels", 10))
      .attribute("wheel_width", &RobotBody::wheel_width, size("width of the wheels", 10))
      .attribute("axle", &RobotBody::axle,
                 size("between the middles of the wheels; by default the wheels stand just outside "
                      "the chassis",
                      10))
      .attribute("mass", &RobotBody::mass, mass("of the chassis"))
      .attribute("wheel_mass", &RobotBody::wheel_mass, mass("of each wheel"))
      .attribute("wheel_torque", &RobotBody::wheel_torque,
                 positive("N m", 1e4, "what the motor of each wheel can give"));
}

// Adds the attribute with which a robot removes a list member of its template.
template <class Member>
Describe<Member> removable(Describe<Member> member) {
  return std::move(member).attribute_before_reading(
      "remove", ParameterType::boolean,
      fact("removes the template's member with this id; no other attribute is allowed then"));
}

ElementSpec segment() {
  return removable(
      Describe<Segment>("segment", "A box on two passive wheels that the robot pulls")
          .costs(Cost::body)
          .attribute("id", &Segment::id,
                     fact("its name on this robot; by default its element's, with a number"), kId)
          .attribute("length", &Segment::length, size("of the box, along its heading", 10))
          .attribute("width", &Segment::width, size("of the box and its wheels, across", 10))
          .attribute("height", &Segment::height, size("of the box", 10))
          .attribute("clearance", &Segment::clearance, size("from the floor to the box", 10))
          .attribute("mass", &Segment::mass, mass("of the whole segment"))
          .attribute("wheel_radius", &Segment::wheel_radius, size("radius of its wheels", 10))
          .attribute("wheel_width", &Segment::wheel_width,
                     size("width of its wheels, which are flush with its sides", 10))
          .attribute("gap", &Segment::gap,
                     size("from the body in front, when they stand in line", 10))
          .attribute("hitch", &Segment::hitch,
                     range("m", 0, 20,
                           "from the middle of the body in front back to the joint; by "
                           "default the joint is in the middle of the gap"))
          .attribute("hitch_height", &Segment::hitch_height,
                     range("m", 0, 20, "of the joint above the floor; by default that of the axle"))
          .attribute("max_yaw_deg", &Segment::max_yaw_deg,
                     range("deg", 1, 170,
                           "how far the joint turns to either side; by default until the "
                           "two bodies would touch, at most 90"))
          .attribute("max_pitch_deg", &Segment::max_pitch_deg,
                     range("deg", 1, 80, "how far the joint bends upwards and downwards")));
}

// A sensor or an actuator.
ElementSpec mounted(const char* name, const char* meaning, PluginKind kind) {
  return removable(
      plugin_use<MountedUse>(name, meaning, kind, Cost::object,
                             "its name on this robot; by default the plugin's, with a number if "
                             "there are several")
          .attribute(
              "segment", &MountedUse::segment,
              fact("the segment of the robot that it is mounted on; by default on the robot"))
          .attribute("x", &MountedUse::x,
                     metres("where it is mounted, ahead; by default the chassis' front"))
          .attribute("y", &MountedUse::y,
                     metres("where it is mounted, to the left; by default the middle"))
          .attribute("z", &MountedUse::z,
                     metres("where it is mounted, up; by default the chassis' top"))
          .attribute("yaw_deg", &MountedUse::yaw_deg, angle("where it looks, to the left"))
          .attribute("pitch_deg", &MountedUse::pitch_deg, angle("where it looks, upwards"))
          .attribute("energy_cost", &MountedUse::energy_cost,
                     range("units/s", 0, 1e12, "the energy that it uses"), kLive));
}

ElementSpec behavior() {
  return removable(
      plugin_use<BehaviorUse>("behavior", "A behaviour", PluginKind::behavior, Cost::object,
                              "its name in its list; by default the plugin's, with a "
                              "number if there are several")
          .holds(&BehaviorUse::inside)
          .attribute("priority", &BehaviorUse::priority,
                     range("", -1e6, 1e6, "its weight or rank; the coordinator decides which"),
                     kLive));
}

// The use of a plugin of which there is at most one.
ElementSpec only_use(const char* name, const char* meaning, PluginKind kind, Cost cost) {
  return removable(
      plugin_use<PluginUse>(name, meaning, kind, cost, "its name; by default the plugin's"));
}

Describe<Coordination> behaviors() {
  return Describe<Coordination>("behaviors", "Behaviours, in the order of their rank in ties")
      .each(behavior(), &Coordination::behaviors);
}

Describe<Coordination> coordinator() {
  return Describe<Coordination>("coordinator", "Makes one command of the behaviours' responses")
      .optional(only_use("coordinator", "A coordinator", PluginKind::coordinator, Cost::object),
                &Coordination::coordinator);
}

// Adds the attributes and elements that robots and robot templates share.
ElementSpec with_robot_content(Describe<Robot> robot) {
  return std::move(robot)
      .attribute_before_reading(
          "template", ParameterType::file,
          fact("a file with a <robot_template>, whose content this element overrides"))
      .attribute("team", &Robot::team, fact("the team that it belongs to"), kTeam)
      .attribute("colour", &Robot::colour,
                 fact("of its chassis; by default that of its team, and grey to cameras that take "
                      "pictures"),
                 {.cost = Cost::nothing})
      .attribute("x", &Robot::x, metres("east"), kLive)
      .attribute("y", &Robot::y, metres("north"), kLive)
      .attribute("z", &Robot::z, range("m", 0, 100, "the bottom of its wheels"), kLive)
      .attribute("heading_deg", &Robot::heading_deg, angle("counter-clockwise from east"), kLive)
      .attribute("max_speed", &Robot::max_speed,
                 range("m/s", 0, 100, "no wheel rolls faster than this"), kLive)
      .attribute(
          "coverage", &Robot::coverage,
          range("m", 0, 1e4, "communication radius, within which robots of its team perceive it"),
          kLive)
      .attribute("leader", &Robot::leader, fact("whether it leads its team"), kLive)
      .attribute("battery", &Robot::battery, positive("units", 1e12, "its battery when full"),
                 kCheap)
      .attribute("energy", &Robot::energy,
                 range("units", 0, 1e12, "in the battery at the start; by default it is full"),
                 kLive)
      .one(body(), &Robot::body)
      .group(
          Describe<Robot>("drive",
                          "The drive of the robot; by default two wheels on one axle "
                          "(differential)")
              .optional(only_use("drive", "A drive", PluginKind::drive, Cost::body), &Robot::drive))
      .group(Describe<Robot>("localisation",
                             "What the robot believes of its place; by default the truth (exact)")
                 .optional(only_use("localisation", "A localisation", PluginKind::localisation,
                                    Cost::object),
                           &Robot::localisation))
      .group(Describe<Robot>("segments", "The boxes that the robot pulls, from front to back")
                 .each(segment(), &Robot::segments))
      .group(Describe<Robot>("sensors", "The robot's sensors")
                 .each(mounted("sensor", "A sensor", PluginKind::sensor), &Robot::sensors))
      .group(Describe<Robot>("actuators", "What the robot does besides moving")
                 .each(mounted("actuator", "An actuator", PluginKind::actuator), &Robot::actuators))
      .group(behaviors())
      .group(coordinator());
}

}  // namespace

const ElementSpec& robot_spec() {
  static const ElementSpec table = with_robot_content(
      Describe<Robot>("robot", "A chassis on a drive, with sensors and behaviours")
          .costs(Cost::engine)
          .attribute("id", &Robot::id, fact("its name"), kRequiredId));
  return table;
}

const ElementSpec& template_vocabulary() {
  static const ElementSpec table = with_robot_content(
      root<Robot>("robot_template", "A robot without an id, to be used in many places"));
  return table;
}

const ElementSpec& coordination_vocabulary() {
  static const ElementSpec table =
      Describe<Coordination>("coordination", "Behaviours and their coordinator")
          .group(behaviors())
          .group(coordinator());
  return table;
}

}  // namespace elsie::world
