// Worlds with layouts, and distances in what was drawn.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "elsie/world/footprint.h"
#include "elsie/world/reader.h"
#include "elsie/world/writer.h"

#include "shipped.h"

namespace elsie::test {

/// Thirty boxes.
inline const std::string kClutter =
    "<layouts><scatter id='clutter' count='30' gap='0.2'><static_box/><heading/></scatter>"
    "</layouts>";

inline std::string scattered(const std::string& attributes, const std::string& inside) {
  return "<layouts><scatter id='c' " + attributes + ">" + inside + "</scatter></layouts>";
}

inline world::World drawn(const std::string& content, std::uint64_t seed = 1,
                          std::vector<std::string> edits = {}) {
  world::ReadOptions options;
  options.seed = seed;
  options.edits = std::move(edits);
  options.data_directories = {source_path("")};
  options.check_plugins = true;
  return world::parse_world("<world format=\"1\">\n" + content + "\n</world>", "w.xml", shipped(),
                            options);
}

/// The world as it came out, as a text.
inline std::string text_of(const std::string& content, std::uint64_t seed = 1,
                           std::vector<std::string> edits = {}) {
  return world::write_world(drawn(content, seed, std::move(edits)));
}

/// What is wrong with it, a line each; "" if nothing is.
inline std::string refusal(const std::string& content, std::uint64_t seed = 1,
                           std::vector<std::string> edits = {}) {
  try {
    drawn(content, seed, std::move(edits));
    return "";
  } catch (const base::FileError& error) {
    return error.what();
  }
}

/// Whether two bodies come nearer than `gap`: an area overlaps the other made larger by it.
inline bool are_nearer(world::Footprint a, const world::Footprint& b, double gap) {
  a.half_length += gap;
  a.half_width += gap;
  return world::overlap(a, b);
}

inline std::vector<world::Footprint> footprints(const world::World& world) {
  std::vector<world::Footprint> all;
  for (const world::Obstacle& box : world.obstacles) all.push_back(world::footprint_of(box));
  for (const world::Robot& robot : world.robots) {
    const auto own = world::footprints_of(world::plan_of(robot),
                                          {robot.x, robot.y, radians(robot.heading_deg)}, robot.z);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

}  // namespace elsie::test
