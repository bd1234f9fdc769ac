#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/parts.h"

#include "reading.h"
#include "refusals.h"

namespace elsie::world {

namespace {

using base::number_text;

std::string in_words(const Robot& robot) {
  return robot.id.empty() ? "this robot" : "the robot '" + robot.id + "'";
}

template <class Objects>
std::vector<std::string> ids_of(const Objects& objects) {
  std::vector<std::string> ids;
  for (const auto& object : objects) {
    if (!object.id.empty()) ids.push_back(object.id);
  }
  return ids;
}

// Checks that what attributes refer to exists.
class MentionCheck {
 public:
  MentionCheck(const World& world, Problems& problems) : world_(world), problems_(problems) {}

  bool exists(Reference kind, const std::string& id) {
    const auto [known, is_new] = known_.try_emplace(kind);
    if (is_new) {
      const std::vector<std::string> ids = this->ids(kind);
      known->second.insert(ids.begin(), ids.end());
    }
    return known->second.contains(id);
  }
  void check(const Mention& mention) {
    if (exists(mention.kind, mention.id)) return;
    const auto [what, is_any] =
        mention.kind == Reference::team    ? std::pair("team", !world_.teams.empty())
        : mention.kind == Reference::robot ? std::pair("robot", !world_.robots.empty())
                                           : std::pair("box", !world_.obstacles.empty());
    const std::vector<std::string> all = ids(mention.kind);
    problems_.add(mention.where,
                  mention.in_words +
                      (mention.id.empty() ? "" : std::string(": there is no such ") + what) +
                      (!all.empty() ? base::near_or_all(mention.id, all, "there are")
                       : is_any     ? "; the world has none with a valid id"
                                    : "; the world has none"));
  }

 private:
  std::vector<std::string> ids(Reference kind) const {
    return kind == Reference::team    ? ids_of(world_.teams)
           : kind == Reference::robot ? ids_of(world_.robots)
                                      : ids_of(world_.obstacles);
  }

  const World& world_;
  Problems& problems_;
  std::map<Reference, std::set<std::string>> known_;
};

void check_physics(const Physics& physics, Problems& problems) {
  const double period = physics.step * physics.control_steps;
  if (period > 1.0) {
    problems.add(physics.location, "the control period, step times control_steps, is " +
                                       number_text(period) + " s; expected at most 1 s");
  }
}

// Checks the requirements of the behaviours and coordinators of a robot.
class CoordinationCheck {
 public:
  CoordinationCheck(const Robot& robot, const plugin::Host& host, Problems& problems)
      : robot_(robot), host_(host), problems_(problems) {}

  void check(const std::vector<PluginUse>& rules) {
    raised_ = simulator_events();
    list_events(robot_, host_, raised_);
    list_events(rules, host_, raised_);
    check(robot_, in_words(robot_), robot_.location);
  }

 private:
  // Checks that a coordinator turns the responses into a command, at any depth, unless all
  // behaviours only act. `whose` and `where` name the robot or the behaviour that holds the
  // coordination.
  void check(const Coordination& coordination, const std::string& whose, const Location& where) {
    const auto moves = [&](const BehaviorUse& use) {
      const Declaration* declaration = host_.find(PluginKind::behavior, use.plugin);
      return !declaration || !declaration->only_acts;
    };
    if (!coordination.coordinator &&
        std::any_of(coordination.behaviors.begin(), coordination.behaviors.end(), moves)) {
      problems_.add(where, whose + " has behaviours but no coordinator; add a <coordinator>");
    }
    for (const BehaviorUse& use : coordination.behaviors) {
      check(use, PluginKind::behavior);
      for (const Coordination& inside : use.inside) {
        const std::string holder = "the behavior '" + use.id + "' of " + whose;
        if (inside.behaviors.empty()) {
          problems_.add(use.location, holder + " holds no behaviours; add <behaviors> with some");
        }
        check(inside, holder, use.location);
      }
    }
    if (coordination.coordinator) check(*coordination.coordinator, PluginKind::coordinator);
  }

  void check(const PluginUse& use, PluginKind kind) {
    const Declaration* declaration = host_.find(kind, use.plugin);
    if (!declaration) return;
    for (const ReadingDeclaration& need : declaration->needs) {
      check_need(use, {PluginKind::sensor, &Declaration::produces, robot_.sensors}, need);
    }
    for (const ReadingDeclaration& need : declaration->commands) {
      check_need(use, {PluginKind::actuator, &Declaration::takes, robot_.actuators}, need);
    }
    for (const std::string& event : declaration->reacts_to) {
      require_event("'" + use.plugin + "' reacts to the event", event, raised_, in_words(robot_),
                    use.location, problems_);
    }
    check_named_events(use, *declaration, raised_, in_words(robot_), problems_);
  }

  // What behaviours need of sensors or of actuators.
  struct Need {
    PluginKind kind;  // of those that have it
    std::vector<ReadingDeclaration> Declaration::*list;
    const std::vector<MountedUse>& uses;  // of the robot

    const ReadingDeclaration* of(const Declaration* plugin, const ReadingDeclaration& need) const {
      if (!plugin) return nullptr;
      const auto found = std::find_if((plugin->*list).begin(), (plugin->*list).end(),
                                      [&](const auto& each) { return each.kind == need.kind; });
      return found == (plugin->*list).end() ? nullptr : &*found;
    }
  };

  // Checks that the robot's sensors make such readings, or that its actuators take such commands.
  void check_need(const PluginUse& use, const Need& of, const ReadingDeclaration& need) {
    const bool reads = of.kind == PluginKind::sensor;
    bool met = false;
    const MountedUse* other_version = nullptr;
    for (const MountedUse& mounted : of.uses) {
      const auto* const had = of.of(host_.find(of.kind, mounted.plugin), need);
      if (had && had->fits(need)) {
        met = true;
      } else if (had) {
        other_version = &mounted;
      }
    }
    const std::string kind(plugin::kind_name(of.kind));
    const std::string what = "'" + use.plugin + "' " +
                             (reads ? "needs readings" : "gives commands") + " of the kind '" +
                             need.kind + "'";
    if (other_version) {
      problems_.add(use.location, what + " as it was built with, but those of the " + kind + " '" +
                                      other_version->plugin +
                                      "' have another layout; build both plugins again with the "
                                      "same header");
    } else if (!met) {
      std::vector<std::string> makers;
      for (const Declaration* plugin : host_.all(of.kind)) {
        const auto* const had = of.of(plugin, need);
        if (had && had->fits(need)) makers.push_back("<" + plugin->name + ">");
      }
      problems_.add(use.location, what + ", but " + in_words(robot_) + " has no " + kind +
                                      (reads ? " that makes them" : " that takes them") +
                                      (makers.empty() ? "; no plugin that was found does"
                                                      : "; add " + base::joined(makers, " or ")));
    }
  }

  const Robot& robot_;
  const plugin::Host& host_;
  Problems& problems_;
  std::vector<std::string> raised_;  // events
};

// Checks that there is room for the wheels of the segments, with joints ahead of the axles.
void check_segments(const Robot& robot, Problems& problems) {
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

// Checks that the readings of a sensor, or the commands of a drive or an actuator, arrive before
// the run ends, and that those under way fit into memory. `one`: "reading".
void check_latency(const PluginUse& use, const std::string& one, const Reading& reading,
                   Problems& problems) {
  constexpr double kMostUnderWay = 100'000;
  double latency = 0.0;
  const Location* where = nullptr;
  for (const ElementUse& element : use.elements) {
    const auto given = element.parameters.find("latency");
    if (element.element != "failure" || given == element.parameters.end()) continue;
    latency += std::get<double>(given->second);
    where = &element.location;
  }
  if (!where) return;
  const Physics& physics = reading.world.physics;
  const double period = physics.step * physics.control_steps;
  const std::string what = "latency=\"" + number_text(latency) + "\" of <failure>: ";
  if (latency >= reading.time_limit_s) {
    problems.add(*where, what + "no " + one + " arrives before the run ends, at " +
                             number_text(reading.time_limit_s) + " s; expected less");
  } else if (latency > kMostUnderWay * period) {
    problems.add(*where, what + "more than 100,000 " + one +
                             "s would be under way, one in each control period; expected at most " +
                             number_text(kMostUnderWay * period, 6) + " s");
  }
}

void check_place(const std::string& kind, const MountedUse& use, const Robot& robot,
                 Problems& problems) {
  if (use.segment.empty()) return;
  std::vector<std::string> ids;
  for (const Segment& segment : robot.segments) ids.push_back(segment.id);
  if (std::find(ids.begin(), ids.end(), use.segment) != ids.end()) return;
  problems.add(use.location, "the " + kind + " '" + use.id + "' is mounted on the segment '" +
                                 use.segment + "', and " + in_words(robot) +
                                 " pulls none of that name" +
                                 (ids.empty() ? "; it pulls none at all"
                                              : base::near_or_all(use.segment, ids, "it pulls")));
}

void check_robot(const Reading& reading, std::size_t index, const plugin::Host& host,
                 bool is_running, Problems& problems) {
  const Robot& robot = reading.world.robots[index];
  const RobotBody& body = robot.body;
  if (reading.sound(robot.location)) {
    // In a running world, `energy` is that of the start or of an edit; `battery` may be less since.
    if ((!is_running || reading.charged_robots.contains(index)) && robot.energy &&
        *robot.energy > robot.battery) {
      problems.add(robot.location, in_words(robot) + " starts with energy " +
                                       number_text(*robot.energy) + ", but its battery holds " +
                                       number_text(robot.battery));
    }
    if (body.round && body.length != body.width) {
      problems.add(robot.location, in_words(robot) + " has a round body that is " +
                                       number_text(body.length) + " m long and " +
                                       number_text(body.width) +
                                       " m wide; expected its diameter as both");
    }
  }
  for (const MountedUse& sensor : robot.sensors) {
    check_place("sensor", sensor, robot, problems);
    check_latency(sensor, "reading", reading, problems);
  }
  for (const MountedUse& actuator : robot.actuators) {
    check_place("actuator", actuator, robot, problems);
    check_latency(actuator, "command", reading, problems);
  }
  if (robot.drive) check_latency(*robot.drive, "command", reading, problems);
  if (reading.sound_with_segments(robot)) check_segments(robot, problems);
  if (!reading.incomplete_robots.contains(index)) {
    CoordinationCheck(robot, host, problems).check(reading.world.rules);
  }
}

void check_edits(const World& world, Problems& problems) {
  for (const TimedEdit& edit : world.edits) {
    if (edit.value.has_value() == edit.element.has_value()) {
      problems.add(edit.location,
                   edit.value ? "<change> has a value and an element in it; expected one of them: "
                                "a value for an attribute, an element for an element"
                              : "<change> lacks what to set; expected value=\"...\", or an "
                                "element in it");
    }
  }
}

void check_engine(const World& world, Problems& problems) {
  const std::string& engine = world.physics.engine;
  if (std::filesystem::exists(plugin::engine_file(engine))) {
    reinterpret_cast<EngineCheck>(plugin::engine_symbol(engine, "elsie_check_world"))(world,
                                                                                      problems);
  }
}

}  // namespace

void check_ids(const Element& holder, const ElementSpec& spec, Problems& problems) {
  struct Ids {
    std::vector<const Attribute*> all;
    std::unordered_set<std::string_view> unchecked;  // not those of members taken over
  };
  std::map<std::string_view, Ids> ids;  // by kind of object
  for (const ElementSpec& group : spec.below()) {
    const Element* list = group.group ? holder.child(group.name) : nullptr;
    const ElementSpec* member = list ? &group.children.front() : nullptr;
    if (!member || member->at_most == 1 || !member->attribute("id")) continue;
    const bool of_boxes = group.name == "obstacles" || group.name == "resources";
    const bool watches = group.name == "measures" || group.name == "rules";
    auto& [all, unchecked] = ids[of_boxes  ? std::string_view("box")
                                 : watches ? std::string_view("measure or rule")
                                           : group.members];
    for (const Element& child : list->children) {
      check_ids(child, *member, problems);
      const Attribute* const id = child.find("id");
      if (id) all.push_back(id);
      if (id && !child.unread) unchecked.insert(id->value);
    }
  }
  for (const auto& [what, known] : ids) {
    std::unordered_map<std::string_view, const Attribute*> firsts;
    for (const Attribute* id : known.all) {
      if (!known.unchecked.contains(id->value)) continue;
      const auto& [first, is_new] = firsts.try_emplace(id->value, id);
      if (is_new) continue;
      problems.add(id->where, "a second " + std::string(what) +
                                  (spec.root ? "" : " of this " + holder.name) + " with the id '" +
                                  id->value + "'; the first is there already" +
                                  on_line(first->second->where, id->where));
    }
  }
}

void check_world(const Reading& reading, const Element& root, const plugin::Host& host,
                 bool is_running, Problems& problems) {
  // After a mistake there, some checks would be about default values.
  const auto is_sound = [&](const char* name) {
    const Element* element = root.child(name);
    return !element || reading.sound(element->where);
  };
  MentionCheck mentions(reading.world, problems);
  for (const Mention& mention : reading.mentions) mentions.check(mention);
  check_physics(reading.world.physics, problems);
  check_edits(reading.world, problems);
  if (is_sound("physics")) check_engine(reading.world, problems);
  for (const std::size_t robot : reading.read_robots) {
    check_robot(reading, robot, host, is_running, problems);
  }
  if (is_sound("arena") && is_sound("limits")) {
    check_goals(reading, host, problems);
    check_places(reading, is_running, problems);
  }
  check_rules(reading, host, problems);
  const Element* const fields = root.child("fields");
  if (is_sound("arena")) check_fields(reading, host, fields && !fields->unread, problems);
}

}  // namespace elsie::world
