// Reads a world file into a checked description.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/error.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

class WorldTree;

struct ReadOptions {
  /// s, of the run for which the world is read, if it is not that of <limits>.
  std::optional<double> time_limit_s;
  /// Edits: attributes to set, each "PATH=VALUE", elements to replace or add, each
  /// "PATH=<element .../>", and what to remove, each "PATH/@remove=true". They are applied after
  /// templates and before all checks. Edits of the attribute `template`, and robots that are
  /// replaced or added, are applied before templates.
  ///
  ///   @name                                    of <world>
  ///   physics/@step                            of an element that may stand once, even if missing
  ///   robot[r1]/@max_speed                     of the robot with this id
  ///   robot[2]/@max_speed                      of the second one
  ///   robot[*]/@max_speed                      of all
  ///   robot[team=red]/@max_speed               of those of this team: none, one or several
  ///   sensor[plugin=lidar]/@max_range          of these sensors of every robot
  ///   robot[r1]/behavior[roam]/@priority       of a behaviour, by its id
  ///   robot[r1]/sensor[1]/@yaw_deg             of the first sensor
  ///   robot[r1]/coordinator/@weighted          of the one coordinator
  ///   coordinator/@weighted                    of every robot's
  ///   obstacle[3]/@x, goal[1]/@radius          of any child of <obstacles>, <goals>
  ///   robot[r1]/coordinator/suppress[2]/@by    of the second such element in the coordinator's
  ///   robot[r1]/behavior[explore]/behavior[roam]/@priority
  ///                                            of a behaviour that another one holds
  ///   robot[r1]/behavior[roam]/@remove         "true" removes the behaviour; also for coordinators
  ///                                            and members of lists: robots, obstacles, goals,
  ///                                            sensors, measures...
  ///   robot[r1]/@max_speed/@remove             "true" removes the attribute: its default applies
  ///   robot[r1]/coordinator                    replaces the coordinator's element, which keeps the
  ///                                            id that the file gave it
  ///   robot[+]                                 adds a robot at the end of the list, which is made
  ///                                            if it is missing
  ///   robot[r1]/sensor[+2]                     adds a sensor in front of the second one
  ///   limits[+]                                adds an element that may stand once, if missing
  ///
  /// Groups (<robots>, <sensors>...) may be left out. A step names a member by its element or by
  /// the group's word for its members. It needs brackets if it could mean several. Numbers count
  /// the elements of the file and added ones, including those that were removed. An added element
  /// without an id gets one as in a file; the ids of other elements do not change.
  std::vector<std::string> edits;
  /// The file with the edits: files that they name are searched in its folder and in the data
  /// directories. "": the user gave the edits, and files are searched in the folder of the
  /// world's file, in the current folder and in the data directories.
  std::string edits_from;
  /// Templates and data files are searched here, in this order, if they are not in the folder of
  /// the file that names them; see default_data_directories().
  std::vector<std::string> data_directories;
  /// Paths of files by their names in the text. They are used before any search.
  std::map<std::string, std::string> files{};
  /// Receives the absolute paths of all files that are found, by their names, unless null.
  std::map<std::string, std::string>* found = nullptr;
  /// Whether to make an object of every plugin, so that errors of Component::configured() are
  /// reported, too. Drives are made in any case: they say which parts a body has.
  bool check_plugins = false;
  /// Whether the world is running. Robots, and boxes that can be pushed or taken, have then moved,
  /// so overlaps of bodies with each other or with walls are not checked.
  bool is_running = false;
  /// The run's seed, from which layouts are drawn that have no seed of their own.
  std::uint64_t seed = 1;
};

/// Reads a world file, merges its templates, applies edits and sets all defaults. Throws
/// WorldError with all problems of the file. A relative name is also searched in the data
/// directories.
///
/// File parameters of the result are absolute paths of existing files; PluginUse::file_names has
/// their names in a world file. Obstacles come before resources in World::obstacles.
World read_world(const std::string& file, const plugin::Host& host,
                 const ReadOptions& options = {});

/// The same for a text. `file` is its name in messages; templates and data files are searched in
/// the folder of `file` first.
World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options = {});

/// A running world after ReadOptions::edits. Only what they lead to is read and checked like a
/// file: the other robots are those of `world`, with the same addresses. Takes the tree of that
/// world apart. Throws WorldError.
World edited(WorldTree&& world, const plugin::Host& host, ReadOptions options);

}  // namespace elsie::world
