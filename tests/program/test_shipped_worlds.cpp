#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "program.h"

using elsie::test::Workplace;
using nlohmann::json;

namespace {
int exit_code(const std::string& world, int seed) {
  Workplace here;
  return here.elsie("run worlds/" + world + ".xml --quiet --seed " + std::to_string(seed))
      .exit_code;
}
}  // namespace

TEST_CASE("The shipped worlds reach their goals") {
  for (const char* world :
       {"open_arena", "corridor", "maze", "clutter", "clutter_moving", "pushing", "ten_robots"}) {
    CAPTURE(world);
    CHECK(exit_code(world, 1) == 0);
  }
}

TEST_CASE(
    "A robot lives ten minutes in the clutter, moving on and touching nothing, whatever the seed") {
  for (int seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    CHECK(exit_code("clutter", seed) == 0);  // its goals: no collision, 40 m, 600 s
  }
}
