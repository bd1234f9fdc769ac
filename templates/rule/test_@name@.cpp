#include <elsie/testing/catch.h>

using namespace elsie::testing;

TEST_CASE("It fills a battery that is nearly empty") {
  Scene now;
  now.robot("r1");
  now["r1"].capacity = 50.0;
  now["r1"].energy = 3.0;
  Rule @name@("@name@", {{"robot", "r1"}});
  CHECK(@name@.apply(now).edits.empty());
  now["r1"].energy = 1.9;
  CHECK(@name@.apply(now.step()).edits == std::vector<std::string>{"robot[r1]/@energy=50"});
  CHECK(@name@.apply(now).events == std::vector<std::string>{"filled of r1"});
}

TEST_CASE("In its world no battery is ever empty") {
  World world = World::from_file("world.xml");
  CHECK(world.run().outcome == elsie::RunEnd::Outcome::success);
  CHECK(world.count("filled", "r1") > 1);
}

TEST_CASE("It keeps its promises, whatever it is shown") {
  CheckOptions options;
  options.settings = {{"robot", "r1"}};
  CHECK_THAT(check_plugin(elsie::PluginKind::rule, "@name@", options), finds_nothing());
}
