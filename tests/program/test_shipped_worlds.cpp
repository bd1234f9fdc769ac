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

TEST_CASE("Robots and trains live in the clutter, and kheperas together, whatever the seed") {
  // Their goals: a long way, and no collision of a robot or of its segments. Of the train's ten
  // minutes two; `make figures` runs all of it.
  const std::pair<const char*, const char*> worlds[] = {
      {"clutter", ""},
      {"khepera", ""},
      {"train", " --set endure/@time=120 --set travel/@distance=15 --set limits/@time=120"}};
  for (const auto& [world, options] : worlds) {
    for (int seed = 2; seed <= 4; ++seed) {
      CAPTURE(world, seed);
      CHECK(exit_code(world, seed, options) == 0);
    }
  }
}
