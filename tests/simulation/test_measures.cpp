// Measures while a world runs: what they see, and what becomes of the run.
#include <memory>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/api/coordinator.h"
#include "elsie/render/world_cameras.h"

#include "measures_support.h"
#include "wheels.h"

using namespace elsie;
using namespace elsie::test;
using elsie::test::wheels;
using simulation::RunResult;
using simulation::Simulation;

TEST_CASE("A measure sees the start, then every step once it is made") {
  struct Seen {
    double time_s;
    bool is_start, decided;
    double x, distance_m;
    Motion command;
    bool asked;
    double share;
  };
  std::vector<Seen> seen;
  Script script;
  script.equipped = [](const Observation& start) {
    CHECK(start.is_start);
    CHECK(start.step_s == 0.01);
    CHECK(start.period_s == Approx(0.03));
    CHECK(start.arena_length_m == 10.0);
    CHECK(start.robot("r1").team == "red");
    CHECK(start.robot("r1").capacity == 5000.0);
    REQUIRE(start.robot("r1").behaviors.size() == 1);
    CHECK(start.robot("r1").behavior("scripted") != nullptr);
    CHECK(start.robot("r1").behavior("nobody") == nullptr);
  };
  script.observe = [&](const Observation& now) {
    const ObservedRobot& r = now.robot("r1");
    const ObservedBehavior& b = r.behaviors[0];
    seen.push_back({now.time_s, now.is_start, now.decided, r.pose.x, r.distance_m, r.command,
                    b.asked, b.robot_share});
  };
  Run run(script);
  run.drive = [](const Perception& now) {
    return now.time_s() > 0.05 ? wheels(5, 5) : wheels(10, 10);
  };
  run.world.physics.control_steps = 3;
  run.world.limits.time = 0.1;
  run.run();
  REQUIRE(seen.size() == 11);
  CHECK(seen[0].is_start);
  CHECK(seen[0].time_s == 0.0);
  CHECK(seen[0].command == Motion{});
  CHECK_FALSE(seen[0].asked);
  for (std::size_t i = 1; i < seen.size(); ++i) {
    CAPTURE(i);
    CHECK_FALSE(seen[i].is_start);
    CHECK(seen[i].time_s == Approx(0.01 * static_cast<double>(i)));
    CHECK(seen[i].decided == (i % 3 == 1));
    CHECK(seen[i].command == (i > 6 ? wheels(5, 5) : wheels(10, 10)));
    CHECK(seen[i].asked);
    CHECK(seen[i].share == 1.0);
    CHECK(seen[i].x > seen[i - 1].x);
    CHECK(seen[i].distance_m > seen[i - 1].distance_m);
  }
}

TEST_CASE("Measures see what is in the world, and what is gone") {
  std::vector<std::size_t> obstacles;
  std::vector<double> cart_x;
  Script script;
  script.observe = [&](const Observation& now) {
    obstacles.push_back(now.obstacles.size());
    for (const ObservedObstacle& box : now.obstacles) {
      if (box.kind == ObservedObstacle::Kind::moving) {
        cart_x.push_back(box.pose.x);
      }
      CHECK((box.id == "food" || box.id == "cart"));
      CHECK((box.id != "food" || box.kind == ObservedObstacle::Kind::resource));
    }
  };
  Run run(script);
  world::Obstacle cart = box("cart", world::ObstacleKind::moving, -2, 0);
  cart.waypoints = {{-3.0, 0.0}};
  run.world.obstacles = {cart, box("food", world::ObstacleKind::resource, 0.2, 0.0)};
  run.run();
  CHECK(obstacles.front() == 2);
  CHECK(obstacles.back() == 1);
  CHECK(cart_x.front() == Approx(-2.0));
  CHECK(cart_x.back() == Approx(-2.2).margin(0.02));  // 0.2 m/s for a second
}

namespace {

/// Gives its only member a share that rounding took below zero.
class SharesBelowZero final : public Coordinator {
 public:
  Motion coordinate(std::span<Member> members, const Perception&) override {
    members[0].respond();
    members[0].trace.share = -1e-10;
    return {};
  }
};

}  // namespace

TEST_CASE("A share that rounding took below zero is no share in the robot's command") {
  std::vector<double> seen;
  Script script;
  script.observe = [&](const Observation& now) {
    seen.push_back(now.robot("r1").behaviors[0].robot_share);
  };
  Run run(script);
  run.scripted.host.add(
      declare<SharesBelowZero>(PluginKind::coordinator, "below_zero", "For a test"));
  run.world.robots[0].coordinator->plugin = "below_zero";
  run.run();
  REQUIRE(seen.size() == 101);
  CHECK(seen.back() == 0.0);
}

TEST_CASE("What a user changes before the start is part of the start") {
  std::vector<double> x;
  Script script;
  script.observe = [&](const Observation& now) { x.push_back(now.robot("r1").pose.x); };
  Run run(script);
  Simulation simulation(run.world, run.scripted.host);
  const std::vector<simulation::TimedEdit> edits{{0.0, {"robot[r1]/@x", "1.5"}}};
  simulation.run({}, edits);
  REQUIRE_FALSE(x.empty());
  CHECK(x.front() == 1.5);
}

TEST_CASE("A run is the same with measures and without") {
  for (const std::string name : {"clutter", "group_to_resource", "nested", "khepera"}) {
    CAPTURE(name);
    world::World plain = shipped_world(name, 15);
    plain.measures.clear();
    world::World measured = plain;
    for (const Declaration* declaration : shipped().all(PluginKind::measure)) {
      if (declaration->name != "place_reached" && declaration->name != "formation_error" &&
          declaration->name != "published" && declaration->name != "field_amount" &&
          declaration->name != "reward" &&
          (declaration->name != "group_gathered" || plain.robots.size() > 1)) {
        measured.measures.push_back(measure(declaration->name));
      }
    }
    const RunResult with =
        Simulation(measured, shipped(), {.seed = 5, .cameras = render::world_cameras}).run();
    const RunResult without =
        Simulation(plain, shipped(), {.seed = 5, .cameras = render::world_cameras}).run();
    CHECK(with.state_hash == without.state_hash);
    CHECK(with.steps == without.steps);
    CHECK(with.measures.size() > without.measures.size());
    // And the values are the same again.
    const RunResult again =
        Simulation(measured, shipped(), {.seed = 5, .cameras = render::world_cameras}).run();
    for (std::size_t i = 0; i < with.measures.size(); ++i) {
      CHECK(with.measures[i].value == again.measures[i].value);
    }
  }
}

TEST_CASE("What a measure says is reported without a robot") {
  Run run;
  const RunResult result = run.run();
  REQUIRE(result.notes.size() == 1);
  CHECK(result.notes[0].robot.empty());
  CHECK(result.notes[0].plugin == "scripted_measure");
  CHECK(result.notes[0].text == "It watches.");
}

TEST_CASE("A measure that is edited while the world runs begins then; the others go on") {
  world::PluginUse whole = measure("path_length", {{"robot", "r1"}});
  whole.id = "whole";
  Run run({}, {measure("path_length", {{"robot", "r1"}}), whole});
  Simulation simulation(run.world, run.scripted.host);
  const auto value = [&](const std::string& name) {
    for (const simulation::MeasuredValue& measured : simulation.result().measures) {
      if (measured.name == name) {
        return measured.value.value_or(-1.0);
      }
    }
    return -2.0;
  };
  advance(simulation, 100);
  const double before = value("whole");
  REQUIRE(before > 0.0);
  CHECK_THROWS_WITH(simulation.edit("measure[path_length]/@robot", "r2"),
                    Catch::Contains("there is no robot 'r2' in the world"));
  CHECK(value("path_length") == before);
  simulation.edit("measure[path_length]", "<path_length/>");
  CHECK(value("whole") == before);
  advance(simulation, 100);
  CHECK(value("path_length") > before);
  CHECK(value("whole") > before);
  CHECK(simulation.notes().back().plugin == "path_length");
}

TEST_CASE("Measures stay when plugins are replaced, which is reported") {
  Run run;
  Simulation simulation(run.world, run.scripted.host);
  simulation.step();
  ScriptedHost other([](const Perception&) { return Response(wheels(1, 1)); });
  Script script;
  script.value = [] { return 2.0; };
  other.host.add(measure_declaration(script));
  const simulation::Replacement replaced = simulation.replace_plugins(other.host);
  CHECK_FALSE(replaced.objects.empty());
  REQUIRE(replaced.notes.size() == 1);
  CHECK_THAT(replaced.notes[0],
             Catch::StartsWith("the measure 'scripted_measure' stays as it was"));
  CHECK_FALSE(value(simulation.result(), "scripted_measure"));
}
