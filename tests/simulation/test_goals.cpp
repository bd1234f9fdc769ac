#include <catch2/catch.hpp>

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;
using simulation::Outcome;
using simulation::Simulation;

namespace {

/// A robot that drives at 0.4 m/s along x, from the origin.
world::World driving(world::Goal goal, double limit_s = 10) {
  world::World world;
  world.robots.push_back(
      robot("r1", 0, 0, 0, behavior("wander", 1, {{"speed", 20.0}, {"restlessness", 0.0}})));
  world.goals.push_back(std::move(goal));
  world.limits.time = limit_s;
  return world;
}

simulation::RunResult run(const world::World& world) { return Simulation(world, shipped()).run(); }

}  // namespace

TEST_CASE("Reach: success as soon as the robot is within the radius") {
  const auto result = run(driving(world::ReachGoal{"r1", 2, 0, 0.2, ""}));
  CHECK(result.outcome == Outcome::success);
  CHECK(result.simulated_s == Approx(4.5).margin(0.1));
  CHECK(result.reason == "all goals are reached");
  CHECK(run(driving(world::ReachGoal{"r1", 2, 1, 0.2, ""})).outcome == Outcome::time_limit);
}

TEST_CASE("Reach: a place may be relative to another robot, and goes with it") {
  auto world = driving(world::ReachGoal{"r2", -1, 0.5, 0.05, "r1"});
  world.robots[0].y = -2;
  world.robots[0].heading_deg = 90;  // it drives north, the place is to the south-west of it
  world.robots.push_back(
      robot("r2", -0.5, 0, 0, behavior("wander", 1, {{"speed", 0.0}, {"restlessness", 0.0}})));
  const auto result = run(world);
  CHECK(result.outcome == Outcome::success);
  CHECK(result.simulated_s == Approx(3.0 / 0.4).margin(0.2));
  world.robots[1].x = 0.5;
  CHECK(run(world).outcome == Outcome::time_limit);
}

TEST_CASE("Travel and endure: how far and how long") {
  CHECK(run(driving(world::TravelGoal{"", 1.0})).simulated_s == Approx(2.5).margin(0.1));
  const auto endured = run(driving(world::EndureGoal{10}));
  CHECK(endured.outcome == Outcome::success);
  CHECK(endured.steps == 1000);
  CHECK(run(driving(world::TravelGoal{"r1", 5.0})).outcome == Outcome::time_limit);
}

TEST_CASE("Collect: all resources of the team") {
  auto world = driving(world::CollectGoal{"red"});
  world.obstacles.push_back(box("a", world::ObstacleKind::resource, 1, 0));
  world.obstacles[0].team = "red";
  world.obstacles.push_back(box("b", world::ObstacleKind::resource, 0, 3));
  world.obstacles[1].team = "blue";
  CHECK(run(world).outcome == Outcome::success);
  world.goals[0] = world::CollectGoal{""};
  CHECK(run(world).outcome == Outcome::time_limit);
}

TEST_CASE("Push: a box brought to its place") {
  auto world = driving(world::PushGoal{"crate", 1.5, 0, 0.1});
  world.obstacles.push_back(box("crate", world::ObstacleKind::dynamic, 0.5, 0));
  world.obstacles[0].mass = 0.05;
  CHECK(run(world).outcome == Outcome::success);
}

TEST_CASE("Gather: every robot near its leader, or near another one where nobody leads") {
  world::World world;
  const auto still = behavior("wander", 1, {{"speed", 0.0}, {"restlessness", 0.0}});
  world.robots.push_back(robot("a", 0, 0, 0, still));
  world.robots.push_back(robot("b", 0.4, 0, 0, still));
  world.robots.push_back(robot("c", 0.8, 0, 0, still));
  world.goals.push_back(world::GatherGoal{"red", 0.5});
  world.limits.time = 0.1;
  CHECK(run(world).outcome == Outcome::success);
  world.robots[0].leader = true;
  CHECK(run(world).outcome == Outcome::time_limit);
  world.goals[0] = world::GatherGoal{"red", 0.9};
  CHECK(run(world).outcome == Outcome::success);
}

TEST_CASE("Leaders that nobody follows have gathered when they are near each other") {
  world::World world;
  const auto still = behavior("wander", 1, {{"speed", 0.0}, {"restlessness", 0.0}});
  world.robots.push_back(robot("a", 0, 0, 0, still));
  world.robots.push_back(robot("b", 2, 0, 0, still));
  world.robots[0].leader = world.robots[1].leader = true;
  world.goals.push_back(world::GatherGoal{"red", 0.5});
  world.limits.time = 0.1;
  CHECK(run(world).outcome == Outcome::time_limit);
  world.robots[1].x = 0.4;
  CHECK(run(world).outcome == Outcome::success);
}

TEST_CASE("A goal to keep: failure when it is broken, success at the time limit") {
  const auto kept = run(driving(world::NoCollisionGoal{}));
  CHECK(kept.outcome == Outcome::success);
  CHECK(kept.reason == "all goals were kept until the time limit");
  auto world = driving(world::NoCollisionGoal{"r1"}, 20);
  const auto broken = run(world);  // the wall is 5 m away
  CHECK(broken.outcome == Outcome::failure);
  CHECK(broken.simulated_s == Approx(12.4).margin(0.3));
  CHECK(broken.reason == "a robot collided, which a goal of the world forbids");

  auto thirsty = driving(world::BatteryGoal{});
  thirsty.robots[0].sensors.push_back(beam("a", 0));
  thirsty.robots[0].energy = 1;
  CHECK(run(thirsty).outcome == Outcome::failure);
}

TEST_CASE("All goals to reach must hold at one instant, and none to keep be broken before") {
  auto world = driving(world::ReachGoal{"r1", 1, 0, 0.2, ""});
  world.goals.push_back(world::EndureGoal{9});
  CHECK(run(world).outcome == Outcome::time_limit);
}

TEST_CASE("Without goals a run ends at the limit of time") {
  auto world = driving(world::EndureGoal{1}, 2);
  world.goals.clear();
  const auto result = run(world);
  CHECK(result.outcome == Outcome::time_limit);
  CHECK(result.simulated_s == Approx(2));
}

TEST_CASE("A limit of time on the clock ends a run too") {
  auto world = driving(world::EndureGoal{1e6}, 1e6);
  world.limits.wall_time = 0.01;
  const auto result = run(world);
  CHECK(result.outcome == Outcome::time_limit);
  CHECK(result.reason == "the limit of time on the clock was met");
}
