// `make figures` runs 20 seeds of every world: docs/shipped-worlds.md.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {
int exit_code(const std::string& world, int seed, const std::string& options = "") {
  Workplace here;
  return here.elsie("run worlds/" + world + ".xml --quiet --seed " + std::to_string(seed) + options)
      .exit_code;
}
}  // namespace

TEST_CASE("The shipped worlds reach their goals") {
  for (const char* world : {"open_arena", "corridor", "maze", "clutter", "clutter_moving",
                            "pushing", "ten_robots", "train", "khepera", "drives"}) {
    CAPTURE(world);
    CHECK(exit_code(world, 1) == 0);
  }
}

TEST_CASE(
    "A robot lives ten minutes in the clutter, moving on and touching nothing, whatever the seed") {
  for (int seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(exit_code("clutter", seed) == 0);  // its goals: no collision, 40 m, 600 s
  }
}

TEST_CASE("A train of three segments finds its way through the clutter, whatever the seed") {
  // Two of the ten minutes; `make figures` runs all of it.
  const std::string two_minutes =
      " --set endure/@time=120 --set travel/@distance=15 --set limits/@time=120";
  for (int seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(exit_code("train", seed, two_minutes) ==
          0);  // neither the robot nor its segments collide
  }
}

TEST_CASE("Kheperas touch neither walls nor boxes nor each other, whatever the noise") {
  for (int seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(exit_code("khepera", seed) == 0);  // its goals: no collision, 15 m each, 300 s
  }
}
