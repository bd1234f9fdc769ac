// The cost of a simulated second of robots that all drive to one point and press against each
// other, for growing crowds: in processor time, and per robot relative to the smallest crowd. One
// process, one core. Prints a table in Markdown.
//
//   crowds [--repeats N]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"

#include "statistics.h"

namespace {

constexpr double kApart = 0.15;    // m, at the start
constexpr double kGather = 3.0;    // s, until they press against each other
constexpr double kMeasured = 3.0;  // s, simulated

elsie::world::World world(int robots) {
  elsie::world::World world;
  world.name = "crowd";
  world.limits.time = 1e6;
  world.teams = {{"red", {}}};
  const int side = static_cast<int>(std::ceil(std::sqrt(robots)));
  for (int i = 0; i < robots; ++i) {
    elsie::world::Robot robot;
    robot.id = "r" + std::to_string(i);
    robot.team = "red";
    robot.coverage = 0.0;
    robot.battery = 1e9;
    robot.x = kApart * (i % side - 0.5 * (side - 1));
    robot.y = kApart * (i / side - 0.5 * (side - 1));
    elsie::world::BehaviorUse drive;
    drive.plugin = drive.id = "go_to_point";
    drive.parameters = {{"x", 0.0}, {"y", 0.0}, {"speed", 20.0}};
    robot.behaviors.push_back(drive);
    robot.coordinator.emplace();
    robot.coordinator->plugin = robot.coordinator->id = "arbiter_suppression";
    world.robots.push_back(robot);
  }
  return world;
}

/// Processor seconds for a simulated second.
double cost(const elsie::plugin::Host& host, int robots) {
  elsie::simulation::Simulation run(world(robots), host);
  while (run.time_s() < kGather) {
    run.step();
  }
  const std::clock_t start = std::clock();
  while (run.time_s() < kGather + kMeasured) {
    run.step();
  }
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kMeasured;
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 5;
  if ((argc != 1 && argc != 3) || repeats < 1) {
    std::fprintf(stderr, "usage: crowds [--repeats N]\n");
    return EXIT_FAILURE;
  }
  try {
    const elsie::plugin::Host host(elsie::plugin::default_search_path());
    const std::vector<int> sizes{25, 50, 100, 200};
    std::vector<std::vector<double>> costs(sizes.size());
    for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
      for (std::size_t k = 0; k < sizes.size(); ++k) {
        costs[k].push_back(cost(host, sizes[k]));
      }
    }
    std::printf(
        "| robots | s for a simulated second | times real time | for each robot, against %d "
        "robots |\n|---|---|---|---|\n",
        sizes[0]);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const double time = elsie::bench::median(costs[k]);
      std::vector<double> ratios;
      for (std::size_t i = 0; i < costs[k].size(); ++i) {
        ratios.push_back(costs[k][i] / sizes[k] / (costs[0][i] / sizes[0]));
      }
      std::printf("| %d | %.3f | %.1f | %.2f |\n", sizes[k], time, 1.0 / time,
                  elsie::bench::median(ratios));
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crowds: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
