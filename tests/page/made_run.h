// Recordings of small runs, for the tests of pages.
#pragma once

#include <string>

#include "recorded.h"

namespace elsie::test {

/// Text that would run a script where a page forgot to escape it.
inline const std::string kHostileText =
    "</script><script>window.hacked=1</script><img src=x onerror=\"window.hacked=1\"> {{data}} "
    "'\"&";

/// Two robots of two teams that drive to and fro, with names of our choice.
inline world::World two_robots(const std::string& first, const std::string& second) {
  world::World world = shipped_world("open_arena.xml", 20);
  world.arena.length = world.arena.width = 6.0;
  REQUIRE_FALSE(world.robots.empty());
  world::Robot robot = world.robots[0];
  world.robots = {robot, robot};
  world.robots[0].id = first;
  world.robots[0].team = "red";
  world.robots[1].id = second;
  world.robots[1].team = "blue";
  world.robots[0].x = -1.5;
  world.robots[1].x = 1.5;
  world.robots[0].y = world.robots[1].y = 0.0;
  world.robots[1].heading_deg = 90.0;
  return world;
}

}  // namespace elsie::test
