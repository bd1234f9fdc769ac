// The speed of robots with cameras relative to real time, on one core: sensing (pictures and what
// is found in them), behaviours, coordinators and physics.
//
//   vision_speed [--repeats N]
//
// World: 10 m x 10 m with walls, 20 boxes and 8 resources without a team. Each robot has a camera
// of 100 x 100 pixels and 30 degrees, which takes a picture 100 times a simulated second and looks
// for resources. The robots wander, so that the same run without cameras can be compared; the two
// are run in turn. The process keeps to one processor; without a graphics card, Mesa's software
// rasteriser draws. Prints a table in Markdown.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <vector>

#include <sched.h>

#include "elsie/plugin/host.h"
#include "elsie/render/renderer.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"

#include "statistics.h"

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRobotSteps = 4000;  // in one measurement

elsie::world::World world(int robots, bool cameras) {
  elsie::world::World world;
  world.name = "benchmark";
  world.limits.time = 1e6;
  world.teams = {{"red", {}}};
  const auto add_obstacle = [&world](elsie::world::ObstacleKind kind, double x, double y) -> auto& {
    elsie::world::Obstacle& box = world.obstacles.emplace_back();
    box.id = "b" + std::to_string(world.obstacles.size());
    box.kind = kind;
    box.x = x;
    box.y = y;
    box.heading_deg = 17.0 * static_cast<double>(world.obstacles.size());
    return box;
  };
  for (int i = 0; i < 20; ++i) {
    auto& box =
        add_obstacle(elsie::world::ObstacleKind::fixed, -3.6 + 1.8 * (i % 5), -2.7 + 1.8 * (i / 5));
    box.length = 0.3;
  }
  for (int i = 0; i < 8; ++i) {
    add_obstacle(elsie::world::ObstacleKind::resource, -4.5 + 9.0 * (i % 3) / 2.0,
                 -3.6 + 1.8 * (i / 2));
  }
  const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
  for (int i = 0; i < robots; ++i) {
    elsie::world::Robot& robot = world.robots.emplace_back();
    robot.id = "r" + std::to_string(i);
    robot.team = "red";
    robot.x = -4.5 + 9.0 * (i % side + 0.5) / side;
    robot.y = -4.5 + 9.0 * (i / side + 0.5) / side;
    robot.heading_deg = (37 * i) % 360;
    robot.battery = 1e9;
    robot.coverage = 0.0;
    if (cameras) {
      elsie::world::MountedUse& camera = robot.sensors.emplace_back();
      camera.plugin = camera.id = "vision";
    }
    elsie::world::BehaviorUse& wander = robot.behaviors.emplace_back();
    wander.plugin = wander.id = "wander";
    robot.coordinator.emplace();
    robot.coordinator->plugin = robot.coordinator->id = "arbiter_suppression";
  }
  return world;
}

/// Simulated time divided by time on the clock.
double speed(elsie::simulation::Simulation& simulation, int steps) {
  simulation.reset();
  for (int i = 0; i < steps / 10; ++i) {
    simulation.step();
  }
  const double before = simulation.time_s();
  const auto start = Clock::now();
  for (int i = 0; i < steps; ++i) {
    simulation.step();
  }
  return (simulation.time_s() - before) /
         std::chrono::duration<double>(Clock::now() - start).count();
}

void measure(const elsie::plugin::Host& host, int robots, int repeats) {
  elsie::simulation::Simulation seeing(world(robots, true), host,
                                       {.cameras = elsie::render::world_cameras});
  elsie::simulation::Simulation blind(world(robots, false), host,
                                      {.cameras = elsie::render::world_cameras});
  const int steps = kRobotSteps / robots;
  std::vector<double> with, without;
  for (int i = 0; i < repeats; ++i) {
    with.push_back(speed(seeing, steps));
    without.push_back(speed(blind, steps));
  }
  const auto [low, high] = std::minmax_element(with.begin(), with.end());
  const double per_picture_ms =
      1e3 * (1.0 / elsie::bench::median(with) - 1.0 / elsie::bench::median(without)) /
      (100.0 * robots);
  std::printf("| %d | %.1f | %.1f to %.1f | %.0f | %.3f |\n", robots, elsie::bench::median(with),
              *low, *high, elsie::bench::median(without), per_picture_ms);
  std::fflush(stdout);
}

void keep_to_one_processor() {
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof(allowed), &allowed) != 0) {
    return;
  }
  for (std::size_t i = 0; i < CPU_SETSIZE; ++i) {
    if (CPU_ISSET(i, &allowed)) {
      cpu_set_t one;
      CPU_ZERO(&one);
      CPU_SET(i, &one);
      sched_setaffinity(0, sizeof(one), &one);
      return;
    }
  }
}

}  // namespace

int main(int argc, char** argv) try {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 15;
  if (repeats < 1) {
    std::fprintf(stderr, "usage: vision_speed [--repeats N]\n");
    return 2;
  }
  keep_to_one_processor();
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::printf("Drawn by: %s.\n\n", elsie::render::Renderer().device().c_str());
  std::printf("| robots | times real time | spread | the same without cameras | a picture, ms |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const int robots : {1, 10, 40}) {
    measure(host, robots, repeats);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
