// A world that was read from a tree, with what its checks need.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/world/object_reader.h"
#include "elsie/world/reader.h"

#include "text_check.h"

namespace elsie::plugin {
class Host;
}

namespace elsie::world {

class Files;

/// An attribute that names a thing that must exist.
struct Mention {
  Reference kind = Reference::none;
  std::string id;
  Location where;
  std::string in_words;  // `team="red" of <robot>`
};

struct Reading {
  World world;
  std::vector<Mention> mentions;
  /// Later checks must not judge the objects of these elements.
  std::vector<Flawed> flawed;
  /// Robots, by their places in World::robots, with a template or a plugin that could not be found.
  std::set<std::size_t> incomplete_robots;

  bool sound(const Location& where) const {
    return std::none_of(flawed.begin(), flawed.end(), [&](const Flawed& each) {
      return !each.spec->plugins && each.where.file == where.file && each.where.line == where.line;
    });
  }
  bool sound_with_segments(const Robot& robot) const {
    return sound(robot.location) &&
           std::all_of(robot.segments.begin(), robot.segments.end(),
                       [&](const Segment& segment) { return sound(segment.location); });
  }
};

/// `check_plugins`: ReadOptions::check_plugins.
Reading read_tree(const Element& root, const plugin::Host& host, const Files& files,
                  bool check_plugins, Problems& problems);

/// The tree of the text of a world: its root element is checked, and its ids are complete. `spans`
/// are the places of its elements, whose Element::object is their place in this list.
Element tree_of_world(std::string_view text, const std::string& file,
                      std::vector<ElementSpan>& spans);

/// The world of a tree that templates and overrides have been applied to. Throws WorldError with
/// all problems, those that are there already included.
World world_of_tree(Element root, const std::string& file, const plugin::Host& host,
                    const Files& files, const ReadOptions& options, Problems& problems);

}  // namespace elsie::world
