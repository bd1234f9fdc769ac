#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/simulator_events.h"
#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/plugin/host.h"
#include "elsie/world/parts.h"
#include "elsie/world/train.h"

#include "reading.h"

namespace elsie::world {

namespace {

using base::number_text;

std::string in_words(const Robot& robot) {
  return robot.id.empty() ? "this robot" : "the robot '" + robot.id + "'";
}

std::string on_line(const Location& where, const Location& from) {
  return where.line == 0           ? " (" + where.file + ")"
         : where.file == from.file ? " (line " + std::to_string(where.line) + ")"
                                   : " (" + where.file + ":" + std::to_string(where.line) + ")";
}

// No two of the elements in these lists have the same id.
void check_unique(const std::vector<const Element*>& lists, const std::string& what,
                  Problems& problems) {
  std::map<std::string, Location> first;
  for (const Element* list : lists) {
    if (!list) {
      continue;
    }
    for (const Element& child : list->children) {
      const Attribute* id = child.find("id");
      if (!id) {
        continue;
      }
      const auto [known, fresh] = first.emplace(id->value, id->where);
      if (!fresh) {
        problems.add(id->where, "a second " + what + " with the id '" + id->value +
                                    "'; the first is there already" +
                                    on_line(known->second, id->where));
      }
    }
  }
}

// Of a robot's behaviours and of those that they hold.
void check_behavior_ids(const Element& holder, Problems& problems) {
  const Element* behaviors = holder.child("behaviors");
  check_unique({behaviors}, "behavior of this " + holder.name, problems);
  if (behaviors) {
    for (const Element& behavior : behaviors->children) {
      check_behavior_ids(behavior, problems);
    }
  }
}

void check_ids(const Element& root, Problems& problems) {
  check_unique({root.child("teams")}, "team", problems);
  check_unique({root.child("obstacles"), root.child("resources")}, "box", problems);
  check_unique({root.child("chargers")}, "charger", problems);
  check_unique({root.child("measures")}, "measure", problems);
  const Element* robots = root.child("robots");
  check_unique({robots}, "robot", problems);
  if (robots) {
    for (const Element& robot : robots->children) {
      check_unique({robot.child("segments")}, "segment of this robot", problems);
      check_unique({robot.child("sensors")}, "sensor of this robot", problems);
      check_behavior_ids(robot, problems);
    }
  }
}

void check_mentions(const Reading& reading, Problems& problems) {
  std::vector<std::string> teams, robots, boxes;
  for (const Team& team : reading.world.teams) {
    teams.push_back(team.id);
  }
  for (const Robot& robot : reading.world.robots) {
    robots.push_back(robot.id);
  }
  for (const Box& box : reading.world.boxes) {
    boxes.push_back(box.id);
  }
  for (const Mention& mention : reading.mentions) {
    const auto& [what, ids] = mention.kind == Reference::team    ? std::pair("team", &teams)
                              : mention.kind == Reference::robot ? std::pair("robot", &robots)
                                                                 : std::pair("box", &boxes);
    if (std::find(ids->begin(), ids->end(), mention.id) == ids->end()) {
      std::vector<std::string> valid = *ids;
      std::erase(valid, "");
      problems.add(mention.where,
                   mention.in_words + ": there is no such " + what +
                       (ids->empty()    ? "; the world has none"
                        : valid.empty() ? "; the world has none with a valid id"
                                        : base::near_or_all(mention.id, valid, "there are")));
    }
  }
}

void check_physics(const Element& root, const Physics& physics, Problems& problems) {
  const Element* element = root.child("physics");
  if (!element) {
    return;
  }
  const Attribute* kp = element->find("kp");
  const Attribute* kd = element->find("kd");
  if (!kp != !kd) {
    problems.add((kp ? kp : kd)->where, std::string("<physics> has '") + (kp ? "kp" : "kd") +
                                            "' without '" + (kp ? "kd" : "kp") +
                                            "'; give both, or erp and cfm instead");
  }
  for (const char* name : {"erp", "cfm"}) {
    const Attribute* attribute = element->find(name);
    if (attribute && kp && kd) {
      problems.add(attribute->where, std::string("<physics> has '") + name +
                                         "' beside kp and kd, from which it follows; take it out");
    }
  }
  const double period = physics.step * physics.control_steps;
  if (period > 1.0) {
    problems.add(element->where, "the control period, step times control_steps, is " +
                                     number_text(period) + " s; expected at most 1 s");
  }
}

// Whether the robot's sensors make the readings that a behaviour or the coordinator needs.
void check_needs(const Robot& robot, const PluginUse& use, PluginKind kind,
                 const plugin::Host& host, Problems& problems) {
  const Declaration* declaration = host.find(kind, use.plugin);
  if (!declaration) {
    return;
  }
  for (const ReadingDeclaration& need : declaration->needs) {
    bool met = false;
    const SensorUse* other_version = nullptr;
    for (const SensorUse& sensor : robot.sensors) {
      const Declaration* made = host.find(PluginKind::sensor, sensor.plugin);
      if (!made) {
        continue;
      }
      for (const ReadingDeclaration& reading : made->produces) {
        if (reading.kind == need.kind) {
          met |= reading.size == need.size;
          other_version = reading.size == need.size ? other_version : &sensor;
        }
      }
    }
    const std::string what = "'" + use.plugin + "' needs readings of the kind '" + need.kind + "'";
    if (other_version) {
      problems.add(use.location, what + " as it was built with, but those of the sensor '" +
                                     other_version->plugin +
                                     "' have another layout; build both plugins anew against the "
                                     "same header");
    } else if (!met) {
      std::string makers;
      for (const Declaration* sensor : host.all(PluginKind::sensor)) {
        for (const ReadingDeclaration& reading : sensor->produces) {
          if (reading.kind == need.kind && reading.size == need.size) {
            makers += (makers.empty() ? "" : " or ") + ("<" + sensor->name + ">");
          }
        }
      }
      problems.add(use.location,
                   what + ", but " + in_words(robot) + " has no sensor that makes them" +
                       (makers.empty() ? "; no plugin that was found does" : "; add " + makers));
    }
  }
}

// Appends the events that behaviours may raise, at any depth.
void list_events(const Coordination& coordination, const plugin::Host& host,
                 std::vector<std::string>& names) {
  for (const BehaviorUse& use : coordination.behaviors) {
    if (const Declaration* declaration = host.find(PluginKind::behavior, use.plugin)) {
      for (const EventDeclaration& event : declaration->events) {
        names.push_back(event.name);
      }
    }
    for (const Coordination& inside : use.inside) {
      list_events(inside, host, names);
    }
  }
}

// Whether somebody raises the events that a behaviour or the coordinator reacts to.
void check_events(const Robot& robot, const PluginUse& use, PluginKind kind,
                  const plugin::Host& host, Problems& problems) {
  const Declaration* declaration = host.find(kind, use.plugin);
  if (!declaration || declaration->reacts_to.empty()) {
    return;
  }
  std::vector<std::string> raised;
  list_events(robot, host, raised);
  for (const events::Facts& event : events::of_simulator()) {
    if (event.is_perceived) {
      raised.emplace_back(event.name);
    }
  }
  for (const std::string& event : declaration->reacts_to) {
    if (std::find(raised.begin(), raised.end(), event) == raised.end()) {
      problems.add(use.location, "'" + use.plugin + "' reacts to the event '" + event +
                                     "', which neither the simulator nor a behaviour of " +
                                     in_words(robot) + " raises" +
                                     base::near_or_all(event, raised, "there are"));
    }
  }
}

void check_body(const Robot& robot, Problems& problems) {
  const RobotBody& body = robot.body;
  if (body.round && body.length != body.width) {
    problems.add(robot.location, in_words(robot) + " has a round body that is " +
                                     number_text(body.length) + " m long and " +
                                     number_text(body.width) +
                                     " m wide; expected its diameter as both");
  }
}

// Whether there is room for the wheels of the segments, and for their joints ahead of their axles.
void check_segments(const Reading& reading, const Robot& robot, Problems& problems) {
  if (!reading.sound_with_segments(robot)) {
    return;
  }
  const std::vector<Coupling> chain = couplings(driven_plan(robot), robot.segments);
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Segment& segment = robot.segments[i];
    const std::string what = "the segment '" + segment.id + "' of " + in_words(robot);
    if (2.0 * segment.wheel_width > segment.width) {
      problems.add(segment.location, what + " is " + number_text(segment.width) +
                                         " m wide, which leaves no room for two wheels of " +
                                         number_text(segment.wheel_width) + " m");
    }
    if (chain[i].ahead <= 0.0) {
      problems.add(segment.location,
                   what + " has its joint " + number_text(chain[i].behind) +
                       " m behind the middle of the body in front; expected less than " +
                       number_text(chain[i].behind + chain[i].ahead) +
                       " m, so that the joint is ahead of the segment's axle");
    }
  }
}

// That the wishes of behaviours are turned into a command, and that all have what they need; to any
// depth. `whose` and `where`: of what has them, a robot or a behaviour.
void check_coordination(const Robot& robot, const Coordination& coordination,
                        const std::string& whose, const Location& where, const plugin::Host& host,
                        Problems& problems) {
  if (!coordination.behaviors.empty() && !coordination.coordinator) {
    problems.add(where, whose + " has behaviours but no coordinator; add a <coordinator>");
  }
  for (const BehaviorUse& use : coordination.behaviors) {
    check_needs(robot, use, PluginKind::behavior, host, problems);
    check_events(robot, use, PluginKind::behavior, host, problems);
    for (const Coordination& inside : use.inside) {
      const std::string holder = "the behavior '" + use.id + "' of " + whose;
      if (inside.behaviors.empty()) {
        problems.add(use.location, holder + " holds no behaviours; add <behaviors> with some");
      }
      check_coordination(robot, inside, holder, use.location, host, problems);
    }
  }
  if (coordination.coordinator) {
    check_needs(robot, *coordination.coordinator, PluginKind::coordinator, host, problems);
    check_events(robot, *coordination.coordinator, PluginKind::coordinator, host, problems);
  }
}

void check_robot(const Reading& reading, std::size_t index, const plugin::Host& host,
                 bool is_running, Problems& problems) {
  const Robot& robot = reading.world.robots[index];
  // A robot that runs began with its energy, whatever its battery holds now.
  if (!is_running && robot.energy && *robot.energy > robot.battery &&
      reading.sound(robot.location)) {
    problems.add(robot.location, in_words(robot) + " starts with energy " +
                                     number_text(*robot.energy) + ", but its battery holds " +
                                     number_text(robot.battery));
  }
  if (reading.sound(robot.location)) {
    check_body(robot, problems);
  }
  check_segments(reading, robot, problems);
  if (reading.incomplete_robots.contains(index)) {
    return;
  }
  check_coordination(robot, robot, in_words(robot), robot.location, host, problems);
}

struct GoalCheck {
  const World& world;
  Problems& problems;

  void operator()(const CollectGoal& goal) const {
    const bool any = std::any_of(world.boxes.begin(), world.boxes.end(), [&](const Box& box) {
      return box.kind == BoxKind::resource && (goal.team.empty() || box.team == goal.team);
    });
    if (!any) {
      problems.add(goal.location,
                   goal.team.empty()
                       ? "<collect> has nothing to collect; expected a <resource> in <resources>"
                       : "<collect> has nothing to collect; expected a <resource> of the team '" +
                             goal.team + "' in <resources>");
    }
  }
  void operator()(const ReachGoal& goal) const {
    if (goal.of.empty()) {
      check_place("<reach>", goal.x, goal.y, goal.location);
    } else if (goal.of == goal.robot) {
      problems.add(goal.location, "<reach> gives the robot '" + goal.robot +
                                      "' a place relative to itself; expected another robot in "
                                      "'of'");
    }
  }
  void operator()(const PushGoal& goal) const {
    check_place("<push>", goal.x, goal.y, goal.location);
    for (const Box& box : world.boxes) {
      if (box.id == goal.box && box.kind != BoxKind::dynamic) {
        problems.add(goal.location, "<push>: the box '" + goal.box +
                                        "' cannot be pushed; expected a <dynamic_box>");
      }
    }
  }
  void operator()(const GatherGoal& goal) const {
    const auto size = std::count_if(world.robots.begin(), world.robots.end(),
                                    [&](const Robot& robot) { return robot.team == goal.team; });
    if (size < 2) {
      problems.add(goal.location, "<gather> needs at least two robots of the team '" + goal.team +
                                      "'; there " + (size == 1 ? "is 1" : "are none"));
    }
  }
  void operator()(const TravelGoal&) const {}
  void operator()(const EndureGoal& goal) const {
    if (goal.time > world.limits.time) {
      problems.add(goal.location, "<endure> lasts " + number_text(goal.time) +
                                      " s, but the run ends after " +
                                      number_text(world.limits.time) + " s; see <limits>");
    }
  }
  void operator()(const NoCollisionGoal&) const {}
  void operator()(const BatteryGoal&) const {}

  void check_place(const std::string& what, double x, double y, const Location& where) const {
    if (std::abs(x) > 0.5 * world.arena.length || std::abs(y) > 0.5 * world.arena.width) {
      problems.add(where, what + ": the place (" + number_text(x) + ", " + number_text(y) +
                              ") is outside of the arena");
    }
  }
};

void check_changes(const World& world, Problems& problems) {
  for (const TimedEdit& edit : world.changes) {
    if (edit.value && edit.element) {
      problems.add(
          edit.location,
          "<change> has a value and an element in it; expected one of them: a value for an "
          "attribute, an element for an element");
    } else if (!edit.value && !edit.element) {
      problems.add(edit.location,
                   "<change> lacks what to set; expected value=\"...\", or an element in it");
    }
  }
}

}  // namespace

void check_world(const Reading& reading, const Element& root, const plugin::Host& host,
                 bool is_running, Problems& problems) {
  check_ids(root, problems);
  check_mentions(reading, problems);
  check_physics(root, reading.world.physics, problems);
  check_changes(reading.world, problems);
  for (std::size_t i = 0; i < reading.world.robots.size(); ++i) {
    check_robot(reading, i, host, is_running, problems);
  }
  // With any mistake in the file's sizes, what follows would be about defaults.
  if (const auto locate =
          [&](const char* name) {
            const Element* element = root.child(name);
            return !element || reading.sound(element->where);
          };
      locate("arena") && locate("limits")) {
    for (const Goal& goal : reading.world.goals) {
      std::visit(
          [&](const auto& each) {
            if (reading.sound(each.location)) {
              GoalCheck{reading.world, problems}(each);
            }
          },
          goal);
    }
    check_places(reading, is_running, problems);
  }
}

}  // namespace elsie::world
