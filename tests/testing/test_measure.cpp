#include "elsie/testing/catch.h"

using namespace elsie::testing;
using elsie::ObservedObstacle;
using elsie::RunEnd;

TEST_CASE("A measure watches a scene that changes from step to step") {
  Scene now;
  now.robot("r1");
  Measure length("path_length", {{"robot", "r1"}});
  length.observe(now);
  CHECK(length.value() == 0.0);
  now["r1"].distance_m = 0.5;
  length.observe(now.step());
  CHECK(length.value() == 0.5);
  length.reset();
  CHECK(length.value() == 0.0);
}

TEST_CASE("A scene begins at its start, and decides once in each control period") {
  Scene now;
  now.steps_of(0.02, 2);
  CHECK(now.observation().is_start);
  CHECK_FALSE(now.observation().decided);
  CHECK(now.observation().period_s == Approx(0.04));
  for (const bool decided : {true, false, true}) {
    CHECK(now.step().observation().decided == decided);
    CHECK_FALSE(now.observation().is_start);
  }
  CHECK(now.time_s() == Approx(0.06));
  CHECK(now.restart().observation().is_start);
  CHECK(now.time_s() == 0.0);
}

TEST_CASE("A copy of a scene is a scene of its own") {
  Scene now;
  now.robot("r1", 1, 2, "green", 90).behaves("wander").resource("food", 3, 4, "blue");
  Scene other = now;
  other["r1"].pose.x = 5.0;
  other.behavior("r1", "wander").share = 1.0;
  other.remove_obstacle("food");
  CHECK(now.observation().robot("r1").pose.x == 1.0);
  CHECK(now.observation().robot("r1").pose.heading_rad == Approx(elsie::radians(90)));
  CHECK(now.observation().robot("r1").behavior("wander")->share == 0.0);
  REQUIRE(now.observation().obstacles.size() == 1);
  CHECK(now.observation().obstacles[0].kind == ObservedObstacle::Kind::resource);
  CHECK(other.observation().robot("r1").behavior("wander")->share == 1.0);
  CHECK(other.observation().obstacles.empty());
  now = Scene();
  CHECK(other.observation().robot("r1").team == "green");
  CHECK(other.observation().teams.size() == 3);
}

TEST_CASE("Shares inside of behaviours are computed") {
  Scene now;
  now.robot("r1").behaves("explore").behaves("explore/wander", "drift");
  now.behavior("r1", "explore").share = 0.5;
  now.behavior("r1", "explore/wander").share = 0.5;
  const auto& robot = now.observation().robot("r1");
  CHECK(robot.behavior("explore")->robot_share == 0.5);
  CHECK(robot.behavior("explore/wander")->robot_share == 0.25);
  CHECK(robot.behavior("explore/wander")->parent == 0);
  CHECK(robot.behavior("explore/wander")->plugin == "drift");
  CHECK(robot.behavior("explore")->plugin == "explore");
}

TEST_CASE("Missing robots and behaviours are reported in sentences") {
  Scene now;
  CHECK_THROWS_WITH(now["r1"], "there is no robot 'r1' in the world; there is none");
  now.robot("r1").behaves("wander");
  CHECK_THROWS_WITH(now["r2"], "there is no robot 'r2' in the world; there is 'r1'");
  CHECK_THROWS_WITH(now.behavior("r1", "flee"), "the robot 'r1' has no behaviour 'flee'");
  CHECK_THROWS_WITH(now.behaves("explore/wander"), Catch::Contains("add that one first"));
  Measure length("path_length");
  CHECK_THROWS_AS(length.value(), std::logic_error);
  length.observe(now);
  CHECK_THROWS_WITH(length.value("width"), "the measure has no value 'width'; there are ''");
  CHECK_THROWS_WITH(Measure("path_lenth"), Catch::Contains("did you mean 'path_length'?"));
  CHECK_THROWS_WITH(Measure("path_length", {{"robt", "r1"}}),
                    Catch::Contains("did you mean 'robot'?"));
}

TEST_CASE("Of many robots only some are listed") {
  Scene now;
  for (int i = 1; i <= 20; ++i) {
    now.robot("r" + std::to_string(i));
  }
  CHECK_THROWS_WITH(now["x"], Catch::EndsWith("'r11', 'r12' and 8 more"));
}

TEST_CASE("A world's measures are read by name") {
  World world = World::from_text(R"(<world format="1">
    <robots><robot id="r1">
      <behaviors><wander/></behaviors>
      <coordinator><arbiter_suppression/></coordinator>
    </robot></robots>
    <measures><path_length id="way"/></measures>
    <limits time="1"/></world>)");
  world.run();
  CHECK(world.measured("way").value() == Approx(world.robot("r1").distance_m));
  CHECK(world.measured("time_s") == Approx(1.0));
  CHECK_THROWS_WITH(world.measured("wy"), "the run has no measure 'wy'; did you mean 'way'?");
}
