// The learning curves of networks, in the result of a run.
#include <string>

#include <catch2/catch.hpp>

#include "measures_support.h"

using namespace elsie;
using namespace elsie::test;
using simulation::RunResult;
using simulation::Simulation;

TEST_CASE("The learning curve of a network is part of the result") {
  const RunResult result = Simulation(shipped_world("learned_priorities", 0.1), shipped()).run();
  REQUIRE_FALSE(result.curves.empty());
  for (const simulation::LearningCurve& curve : result.curves) {
    CHECK_FALSE(curve.robot.empty());
    CHECK_THAT(curve.plugin, Catch::Contains("neural_network"));
    CHECK(curve.curve.name == "error");
    CHECK(curve.curve.x_label == "presentations");
    const auto& points = curve.curve.points;
    REQUIRE(points.size() > 100);
    CHECK(points.size() <= 200);
    CHECK(points.back().x == Approx(200'000).epsilon(0.01));
    for (std::size_t i = 1; i < points.size(); ++i) {
      CHECK(points[i].x > points[i - 1].x);
      CHECK(points[i].y >= 0.0);
    }
    CHECK(points.back().y < points.front().y);
  }
}

TEST_CASE("So is that of a network inside a behaviour") {
  const std::string training = source_path("training_sets/two_sensors_two_behaviors.txt");
  const auto run = [&](const std::string& outer) {
    const std::string text = R"(<world format="1"><robots><robot id="r1">
      <sensors><beam_range id="left" yaw_deg="15"/><beam_range id="right" yaw_deg="-15"/></sensors>
      <behaviors>
        <blend id="explore">
          <behaviors><avoid_obstacle/><wander/></behaviors>
          <coordinator><arbiter_neural_network presentations="90" training=")" +
                             training + R"("/></coordinator>
        </blend>
        <wander/>
      </behaviors>
      <coordinator>)" + outer +
                             R"(</coordinator></robot></robots><limits time="0.05"/></world>)";
    world::ReadOptions options;
    options.data_directories = {source_path("")};
    return Simulation(world::parse_world(text, "nets.xml", shipped(), options), shipped()).run();
  };
  const RunResult one = run("<arbiter_suppression/>");
  REQUIRE(one.curves.size() == 1);
  CHECK(one.curves[0].robot == "r1");
  CHECK(one.curves[0].plugin == "explore/arbiter_neural_network");
  // Nine samples, ten epochs: each is a point.
  REQUIRE(one.curves[0].curve.points.size() == 10);
  CHECK(one.curves[0].curve.points[0].x == 9.0);
  CHECK(one.curves[0].curve.points[9].x == 90.0);
  const RunResult two = run("<fusion_neural_network training=\"" + training + "\"/>");
  REQUIRE(two.curves.size() == 2);
  CHECK(two.curves[0].plugin == "explore/arbiter_neural_network");
  CHECK(two.curves[1].plugin == "fusion_neural_network");
}

TEST_CASE("Where nothing was trained there is no curve") {
  world::World world = shipped_world("learned_priorities", 0.05);
  world::World plain = world;
  plain.robots[0].coordinator->plugin = "fusion_vector_summation";
  plain.robots[0].coordinator->parameters.clear();
  CHECK(Simulation(plain, shipped()).run().curves.empty());
  CHECK(Simulation(world, shipped()).run().curves.size() == 1);
}
