// The steps of reading a world from a tree, and the data that its checks need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/world/object_reader.h"
#include "elsie/world/reader.h"

namespace elsie::world {

class Files;

/// An attribute that refers to an object that must exist.
struct Mention {
  Reference kind = Reference::none;
  std::string id;
  Location where;
  std::string in_words;  // `team="red" of <robot>`
};

struct Reading {
  World world;
  double time_limit_s = 0.0;  // of the run
  std::vector<Mention> mentions;
  /// Later checks must ignore the objects of these elements.
  std::vector<Flawed> flawed;
  /// The indices in World::robots of robots whose template or plugin could not be found.
  std::set<std::size_t> incomplete_robots;
  std::set<std::size_t> charged_robots;  // whose `energy` an edit sets
  /// The others are taken over from a world in memory.
  std::vector<std::size_t> read_robots;

  bool has_flaw(const Location& where, bool of_plugins = true) const {
    return std::any_of(flawed.begin(), flawed.end(), [&](const Flawed& each) {
      return (of_plugins || !each.spec->plugins) && each.where.file == where.file &&
             each.where.line == where.line;
    });
  }
  bool sound(const Location& where) const { return !has_flaw(where, false); }
  bool sound_with_segments(const Robot& robot) const {
    return sound(robot.location) &&
           std::all_of(robot.segments.begin(), robot.segments.end(),
                       [&](const Segment& segment) { return sound(segment.location); });
  }
};

/// Checks that no two members of a list have the same id, to any depth. `spec` describes the
/// holder. All boxes count as one list.
void check_ids(const Element& holder, const ElementSpec& spec, Problems& problems);

/// Reads the objects of a tree, and removes the members of its lists. `check_plugins`:
/// ReadOptions::check_plugins.
Reading read_tree(Element& root, const plugin::Host& host, const Files& files, bool check_plugins,
                  Problems& problems);

/// Reads the image of the floor, or takes over that of `before`, unless null. `root` is the tree
/// that the world was read from.
void read_floor_image(World& world, const Element& root, const World* before, const Files& files,
                      Problems& problems);

/// Asks the drives for the parts of their robots and sets Robot::driven. Adds a problem for each
/// drive that does not fit its chassis or makes an impossible body.
void build_bodies(Reading& reading, const plugin::Host& host, Problems& problems);

/// Checks conditions on more than one attribute. `root` is the tree that the world was read from,
/// after templates and edits; its lists are empty by now. `is_running`:
/// ReadOptions::is_running.
void check_world(const Reading& reading, const Element& root, const plugin::Host& host,
                 bool is_running, Problems& problems);

/// The events of the simulator that behaviours perceive.
std::vector<std::string> simulator_events();
/// Adds the events that rules may raise.
void list_events(const std::vector<PluginUse>& rules, const plugin::Host& host,
                 std::vector<std::string>& raised);
/// Adds the events that behaviours may raise, at any depth.
void list_events(const Coordination& coordination, const plugin::Host& host,
                 std::vector<std::string>& raised);

/// Adds a problem if an event is not among `raised`. `what` comes before its name, `whose` are the
/// behaviours: "the robot 'r1'".
void require_event(const std::string& what, const std::string& event,
                   std::vector<std::string> raised, const std::string& whose, const Location& where,
                   Problems& problems);
/// Checks the parameters of a plugin that name events; see names_event().
void check_named_events(const PluginUse& use, const Declaration& declaration,
                        const std::vector<std::string>& raised, const std::string& whose,
                        Problems& problems);
/// The part of check_world() about the events that rules name.
void check_rules(const Reading& reading, const plugin::Host& host, Problems& problems);

/// The part of check_world() about goals.
void check_goals(const Reading& reading, const plugin::Host& host, Problems& problems);

/// The part of check_world() about positions. Static obstacles may overlap each other and the
/// walls, as in mazes, and moving obstacles may pass through them. Robots, dynamic boxes and
/// resources must not overlap anything.
void check_places(const Reading& reading, bool is_running, Problems& problems);

/// Checks that no field has too many cells, and that the sensors and actuators of robots name
/// fields of the world. `all`: of all robots, not only of those that were read.
void check_fields(const Reading& reading, const plugin::Host& host, bool all, Problems& problems);

}  // namespace elsie::world
