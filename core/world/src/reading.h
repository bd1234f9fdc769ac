// A world that is being read: what checks need to know besides the world itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/world/description.h"
#include "elsie/world/vocabulary.h"

namespace elsie::world {

/// An attribute that names something that must exist.
struct Mention {
  Reference kind = Reference::none;
  std::string id;
  Location where;
  std::string in_words;  // `team="red" of <robot>`
};

struct Reading {
  World world;
  std::vector<Mention> mentions;
  /// Elements with mistakes of their own: what they describe has defaults where they are wrong, and
  /// is not to be judged by those.
  std::set<std::pair<std::string, int>> unsound;
  /// Robots of which something could not be read: a template, or what plugin is meant. By their
  /// places in World::robots; their ids may be wrong.
  std::set<std::size_t> incomplete_robots;

  bool sound(const Location& where) const { return !unsound.contains({where.file, where.line}); }
  bool sound_with_segments(const Robot& robot) const {
    return sound(robot.location) &&
           std::all_of(robot.segments.begin(), robot.segments.end(),
                       [&](const Segment& segment) { return sound(segment.location); });
  }
};

}  // namespace elsie::world
