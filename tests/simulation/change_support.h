// Worlds that are changed while they run.
#pragma once

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "elsie/plugin/parameters.h"
#include "elsie/world/attributes.h"

#include "world_builder.h"

namespace elsie::test {

using simulation::EditRefused;
using simulation::Simulation;

/// A simulation of these robots, each with a beam to look at.
inline Simulation run_of(const ScriptedHost& scripted, std::vector<world::Robot> robots) {
  world::World world;
  world.robots = std::move(robots);
  for (world::Robot& robot : world.robots) {
    world::MountedUse sensor = beam("ahead", 0);
    sensor.energy_cost = 0;
    robot.sensors.push_back(sensor);
  }
  return Simulation(world, scripted.host);
}

inline simulation::Edit change_of(std::size_t robot, const char* attribute,
                                  const ParameterValue& value) {
  return {"robot[" + std::to_string(robot + 1) + "]/@" + attribute, plugin::format_value(value)};
}

/// Changes an attribute of the robot of this index.
inline void set(Simulation& simulation, std::size_t robot, const char* attribute,
                const ParameterValue& value) {
  const simulation::Edit one = change_of(robot, attribute, value);
  simulation.edit(one.path, one.value);
}

/// Puts it at a pose on the floor.
inline void place(Simulation& simulation, std::size_t robot, const Pose& pose) {
  simulation.edit(std::vector<simulation::Edit>{
      change_of(robot, "x", pose.x), change_of(robot, "y", pose.y), change_of(robot, "z", 0.0),
      change_of(robot, "heading_deg", degrees(pose.heading_rad))});
}

inline world::Segment segment(const std::string& id) {
  world::Segment segment;
  segment.id = id;
  return segment;
}

/// The sentence with which a change is refused; "" when it is made.
template <class Change>
std::string why_not(Change change) {
  try {
    change();
    return "";
  } catch (const EditRefused& refused) {
    return refused.what();
  }
}

/// "TIME NAME DETAIL" of each.
inline std::vector<std::string> events_of(const Simulation& simulation) {
  std::vector<std::string> texts;
  for (const auto& event : simulation.events()) {
    std::ostringstream text;
    text << event.time_s << ' ' << event.name() << ' ' << event.detail();
    texts.push_back(text.str());
  }
  return texts;
}

}  // namespace elsie::test
