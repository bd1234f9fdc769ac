// Results of the shipped worlds over several seeds: success rate, distance, contacts a minute,
// time.
//
//   world_figures WORLD.xml... [--seeds N]
//
// Seeds 1 to N (20). Prints a table in Markdown with mean and standard deviation over the seeds;
// for several robots, their mean.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/render/world_cameras.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "statistics.h"

namespace {

using elsie::bench::mean_and_deviation;

struct Figures {
  std::vector<double> distance_m, contacts_per_minute, time_s;
  int successes = 0;
};

Figures run(const elsie::world::World& world, const elsie::plugin::Host& host, int seeds) {
  Figures figures;
  elsie::simulation::Simulation simulation(world, host, {.cameras = elsie::render::world_cameras});
  for (int seed = 1; seed <= seeds; ++seed) {
    simulation.reset(static_cast<std::uint64_t>(seed));
    const auto result = simulation.run();
    double distance = 0.0, contacts = 0.0;
    for (const auto& robot : result.robots) {
      distance += robot.distance_m;
      contacts += robot.collisions;
    }
    const auto robots = static_cast<double>(result.robots.size());
    figures.distance_m.push_back(distance / robots);
    figures.contacts_per_minute.push_back(60.0 * contacts / robots / result.simulated_s);
    figures.time_s.push_back(result.simulated_s);
    figures.successes += result.outcome == elsie::simulation::Outcome::success;
  }
  return figures;
}

void print(const std::string& name, const elsie::world::World& world, const Figures& figures) {
  std::printf("| `%s` | %zu | %d of %zu | %s | %s | %s |\n", name.c_str(), world.robots.size(),
              figures.successes, figures.time_s.size(),
              mean_and_deviation(figures.time_s, 1).c_str(),
              mean_and_deviation(figures.contacts_per_minute, 2).c_str(),
              mean_and_deviation(figures.distance_m, 1).c_str());
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) try {
  std::vector<std::string> files(argv + 1, argv + argc);
  int seeds = 20;
  if (const auto option = std::find(files.begin(), files.end(), "--seeds"); option != files.end()) {
    seeds = option + 1 == files.end() ? 0 : std::atoi((option + 1)->c_str());
    files.erase(option, std::min(option + 2, files.end()));
  }
  if (files.empty() || seeds < 1) {
    std::fprintf(stderr, "usage: world_figures WORLD.xml... [--seeds N]\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  elsie::world::ReadOptions options;
  options.data_directories = {ELSIE_SOURCE_DIR};
  std::printf(
      "| world | robots | success | time s | contacts a minute and robot | distance m a robot |\n");
  std::printf("|---|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    const auto world = elsie::world::read_world(file, host, options);
    print(std::filesystem::path(file).filename().string(), world, run(world, host, seeds));
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
