#include <elsie/testing/catch.h>

namespace testing = elsie::testing;
using testing::Situation;

TEST_CASE("Where all is clear it drives on, and it backs away from what is too near") {
  testing::Behavior shy("shy", {{"comfort", 0.4}});
  CHECK_THAT(shy.respond(Situation().beam(0, 1.0)), testing::commands_wheels(10, 10));
  CHECK_THAT(shy.respond(Situation().beam(0, 0.2)), testing::stands());
  CHECK_THAT(shy.respond(Situation().beam(15, 0.3).beam(-15, 0.1)), testing::backs_up());
}

TEST_CASE("In its world it comes near the wall and does not touch it") {
  testing::World world = testing::World::from_file("world.xml");
  world.run_for(15.0);
  CHECK(world.pose("r1").x > 1.5);
  CHECK(world.count("collision") == 0);
}

TEST_CASE("Nothing else is wrong with it") {
  CHECK_THAT(testing::check_plugin(elsie::PluginKind::behavior, "shy"), testing::finds_nothing());
}
