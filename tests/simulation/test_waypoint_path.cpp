#include <catch2/catch.hpp>

#include "world_builder.h"

using namespace elsie;
using namespace elsie::test;

namespace {
/// Where the only box of a world is after some time.
Pose after(world::Obstacle moving, double time_s) {
  world::World world;
  world.obstacles.push_back(std::move(moving));
  simulation::Simulation simulation(world, shipped());
  while (simulation.time_s() < time_s - 1e-9) {
    simulation.step();
  }
  return *simulation.obstacle(0);
}

world::Obstacle square() {
  world::Obstacle moving = box("m", world::ObstacleKind::moving, 0, 0);
  moving.waypoints = {{1, 0}, {1, 1}};
  moving.speed = 1;
  return moving;
}
}  // namespace

TEST_CASE("A round trip goes through the waypoints and straight back to the start") {
  CHECK(after(square(), 0.5).x == Approx(0.5).margin(1e-6));
  CHECK(after(square(), 1.5).y == Approx(0.5).margin(1e-6));
  const Pose back = after(square(), 2.0 + std::sqrt(2.0) / 2);
  CHECK(back.x == Approx(0.5).margin(0.01));
  CHECK(back.y == Approx(0.5).margin(0.01));
}

TEST_CASE("To and fro comes back the same way") {
  world::Obstacle moving = square();
  moving.round_trip = false;
  const Pose pose = after(moving, 3.5);
  CHECK(pose.x == Approx(0.5).margin(1e-6));
  CHECK(pose.y == Approx(0.0).margin(1e-6));
  CHECK(after(moving, 4.25).x == Approx(0.25).margin(1e-6));
}

TEST_CASE("A moving box without a way stays") {
  world::Obstacle moving = box("m", world::ObstacleKind::moving, 0.3, 0.4);
  CHECK(after(moving, 0.5).x == Approx(0.3));
}
