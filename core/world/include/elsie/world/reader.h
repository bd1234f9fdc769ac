// Reading a world file: XML in, a checked description out.
#pragma once

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

struct ReadOptions {
  /// Attributes to change, each "PATH=VALUE", or elements to replace, each "PATH=<element .../>",
  /// after templates are merged in and before anything is checked (the attribute `template` itself:
  /// before they are merged).
  ///
  ///   @name                                    of <world>
  ///   physics/@step                            of an element that stands once; made when missing
  ///   robot[r1]/@max_speed                     of the robot with this id
  ///   robot[2]/@max_speed                      of the second one
  ///   robot[*]/@max_speed                      of all
  ///   robot[r1]/behavior[roam]/@priority       of a behaviour, by its id
  ///   robot[r1]/sensor[1]/@yaw_deg             of the first sensor
  ///   robot[r1]/coordinator/@weighted          of the one coordinator
  ///   coordinator/@weighted                    of every robot's
  ///   obstacle[3]/@x, goal[1]/@radius          of any child of <obstacles>, <goals>
  ///   robot[r1]/coordinator/suppress[2]/@by    of the second such element in the coordinator's
  ///   robot[r1]/behavior[explore]/behavior[roam]/@priority
  ///                                            of a behaviour that another one holds
  ///   robot[r1]/behavior[roam]/@remove         "true" takes the behaviour away; so with whatever
  ///                                            may stand any number of times: robots, obstacles,
  ///                                            goals, sensors, measures..., and with coordinators
  ///   robot[r1]/coordinator                    the coordinator's element, to be replaced; it keeps
  ///                                            an id that was given to it
  ///
  /// Groups (<robots>, <sensors>...) may be left out or named; a member is called by its element's
  /// name or by its group's word for it. A step that could mean several elements needs brackets.
  /// Numbers count what the file has: an element that is taken away counts, whatever the order.
  std::vector<std::string> overrides;
  /// The file in which the overrides stand: what files they name are looked for beside it and in
  /// the data directories. "": they were given by hand, and are looked for beside the world's file
  /// and in the current folder, too.
  std::string overrides_from;
  /// Where templates and data files are looked for when they are not beside the file that names
  /// them, in this order; default_data_directories() are those of the program.
  std::vector<std::string> data_directories;
  /// Files that are known beforehand: what the text calls one, and where it is. They come before
  /// everything that is found.
  std::map<std::string, std::string> files{};
  /// Whether to make every plugin's object once, so that what it says about its parameters in
  /// Component::configured() is reported too.
  bool check_plugins = false;
  /// Leave out, unread, sensors, behaviours, coordinators, measures, the limits of the run, goals
  /// about time: what is left needs no plugin. For those who only want to look at the world.
  bool bodies_only = false;
};

/// Reads a world file, with its templates merged in, overrides applied and every default filled in.
/// Throws WorldError with all the problems of the file; nothing half read is ever returned. A file
/// that is not there under a relative name is looked for in the data directories.
///
/// The result's file parameters hold absolute paths of files that exist, and beside them stands how
/// a world names these (PluginUse::file_names). Obstacles stand before
/// resources in World::boxes.
World read_world(const std::string& file, const plugin::Host& host,
                 const ReadOptions& options = {});

/// The same for text that is in memory; `file` is what it is called in messages, and its folder is
/// where templates and data files are looked for first.
World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options = {});

}  // namespace elsie::world
