#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("In its world the robot gets to its place") {
  World world = World::from_file("world.xml");
  CHECK(world.run().outcome == elsie::simulation::Outcome::success);
}

TEST_CASE("It keeps its promises, wherever the robot drives") {
  CHECK_THAT(check_plugin(elsie::PluginKind::localisation, "@name@"), finds_nothing());
}
