#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("It keeps the largest distance, and when it was") {
  Scene now;
  now.robot("r1", 1, 1);
  Measure @name@("@name@", {{"robot", "r1"}});
  @name@.observe(now);
  for (const double x : {2.0, 4.0, 3.0}) {
    now["r1"].pose.x = x;
    @name@.observe(now.step());
  }
  CHECK(@name@.value() == 3.0);
  CHECK(@name@.value("at_s") == 0.02);
}

TEST_CASE("In its world the robot gets as far as its goal") {
  World world = World::from_file("world.xml");
  world.run();
  CHECK(world.measured("@name@").value() > 1.2);
}

TEST_CASE("It keeps its promises, whatever it is shown") {
  CheckOptions options;
  options.settings = {{"robot", "r1"}};
  CHECK_THAT(check_plugin(elsie::PluginKind::measure, "@name@", options), finds_nothing());
}
