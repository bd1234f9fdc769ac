// What one sensor of each kind on every robot costs a swarm, against the same robots without
// sensors: processor time on the planar engine, on one core. Prints a table in Markdown.
//
//   senses [--robots N] [--repeats N] [SENSOR...]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"

#include "apart.h"
#include "arena_of_robots.h"
#include "statistics.h"

namespace {

using namespace elsie;

constexpr int kFirst = 20;  // steps that are not measured

/// Robots that roam, each with this sensor at its default place, or without any.
world::World swarm(int robots, const std::string& sensor) {
  world::World world = bench::arena_of_robots(robots);
  world.physics.engine = "planar";
  world.lamps.emplace_back();
  for (world::Robot& robot : world.robots) {
    world::BehaviorUse roam;
    roam.plugin = roam.id = "wander";
    robot.behaviors = {roam};
    robot.sensors.clear();
    if (sensor.empty()) continue;
    world::MountedUse& use = robot.sensors.emplace_back();
    use.plugin = use.id = sensor;
    use.x = 0.04;
    use.z = 0.05;
  }
  return world;
}

/// Processor time for a step, s, in a process of its own.
double cost(const plugin::Host& host, const world::World& world) {
  const int steps = world.robots.size() > 1000 ? 100 : 1000;
  return bench::apart([&] {
    simulation::Simulation run(world, host);
    for (int i = 0; i < kFirst; ++i) run.step();
    const std::clock_t start = std::clock();
    for (int i = 0; i < steps; ++i) run.step();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / steps;
  });
}

}  // namespace

int main(int argc, char** argv) {
  int robots = 1000, repeats = 5;
  std::vector<std::string> sensors;
  bool is_sound = true;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if ((word == "--robots" || word == "--repeats") && i + 1 < argc) {
      (word == "--robots" ? robots : repeats) = std::atoi(argv[++i]);
    } else {
      is_sound = is_sound && !word.starts_with('-');
      sensors.push_back(word);
    }
  }
  if (!is_sound || robots < 1 || repeats < 1) {
    std::fprintf(stderr, "usage: senses [--robots N] [--repeats N] [SENSOR...]\n");
    return EXIT_FAILURE;
  }
  try {
    const plugin::Host host(plugin::default_search_path());
    if (sensors.empty()) {
      for (const Declaration* sensor : host.all(PluginKind::sensor)) {
        if (sensor->name != "vision") sensors.push_back(sensor->name);  // see "Cameras"
      }
    }
    const world::World bare = swarm(robots, "");
    std::printf(
        "%d robots.\n\n| sensor | us per robot and step | speed, relative to no sensor "
        "|\n|---|---|---|\n",
        robots);
    for (const std::string& sensor : sensors) {
      const world::World equipped = swarm(robots, sensor);
      std::vector<double> times, speeds;
      for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
        const double without = cost(host, bare);
        times.push_back(1e6 * cost(host, equipped) / robots);
        speeds.push_back(1e6 * without / robots / times.back());
      }
      const auto [least, most] = std::minmax_element(speeds.begin(), speeds.end());
      std::printf("| %s | %.2f | %.0f %% (%.0f to %.0f) |\n", sensor.c_str(), bench::median(times),
                  100.0 * bench::median(speeds), 100.0 * *least, 100.0 * *most);
      std::fflush(stdout);
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "senses: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
