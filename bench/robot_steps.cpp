// Robot-steps per second of a whole simulation (sensors, behaviours, coordinator, physics) compared
// with a bare ODE loop that does the same work, in one process; memory; the time to load a world of
// 100 robots.
//
//   robot_steps [--repeats N]
//
// World: arena_of_robots.h. Both sides get the same poses, the same boxes and the same rule.
// The two are run in turn, and the ratio is taken pair by pair, because machines drift. Prints a
// table in Markdown.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"
#include "elsie/world/writer.h"

#include "arena_of_robots.h"
#include "bare_ode.h"
#include "statistics.h"

namespace {

using elsie::Pose;
using Clock = std::chrono::steady_clock;

constexpr int kStepsInAll = 40000;  // robot-steps in one measurement

double seconds(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

/// The memory of the process in MiB.
double memory_mib() {
  std::ifstream statm("/proc/self/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  statm >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

/// The memory that a simulation with so many robots adds to a process, MiB; measured in a new
/// process, which has no freed memory to reuse.
double memory_of_simulation(const elsie::plugin::Host& host, int robots) {
  int ends[2];
  if (pipe(ends) != 0) {
    throw std::runtime_error("cannot make a pipe");
  }
  const pid_t child = fork();
  if (child == 0) {
    const elsie::world::World description = elsie::bench::arena_of_robots(robots);
    const double before = memory_mib();
    elsie::simulation::Simulation simulation(description, host);
    for (int i = 0; i < 100; ++i) {
      simulation.step();
    }
    const double added = memory_mib() - before;
    _exit(write(ends[1], &added, sizeof(added)) == sizeof(added) ? 0 : 1);
  }
  double added = 0.0;
  const bool was_measured = child > 0 && read(ends[0], &added, sizeof(added)) == sizeof(added);
  close(ends[0]);
  close(ends[1]);
  waitpid(child, nullptr, 0);
  if (!was_measured) {
    throw std::runtime_error("the memory of a simulation could not be measured");
  }
  return added;
}

void compare(const elsie::plugin::Host& host, int robots, int repeats, double memory) {
  const elsie::world::World description = elsie::bench::arena_of_robots(robots);
  const std::vector<Pose> poses = elsie::bench::poses_of(description);
  elsie::simulation::Simulation simulation(description, host);
  std::vector<double> azimuths;
  for (const double azimuth : elsie::bench::kBeamAzimuths_deg) {
    azimuths.push_back(elsie::radians(azimuth));
  }
  const int steps = kStepsInAll / robots;
  const auto rate = [&](auto& side) {
    for (int i = 0; i < steps / 4; ++i) {
      side.step();  // warm up: the robots spread
    }
    const auto start = Clock::now();
    for (int i = 0; i < steps; ++i) {
      side.step();
    }
    return static_cast<double>(steps) * robots / seconds(start);
  };
  std::vector<double> ours, theirs, ratios;
  for (int i = 0; i < repeats; ++i) {
    // Both start again: after some minutes of simulated time, the bare loop becomes unstable.
    simulation.reset();
    elsie::bench::BareOde bare(poses, description.boxes, azimuths, description.physics,
                               description.arena, elsie::bench::steer);
    ours.push_back(rate(simulation));
    theirs.push_back(rate(bare));
    ratios.push_back(ours.back() / theirs.back());
  }
  const auto [low, high] = std::minmax_element(ratios.begin(), ratios.end());
  std::printf("| %d | %.0f | %.0f | %.2f | %.2f to %.2f | %.1f |\n", robots,
              elsie::bench::median(ours), elsie::bench::median(theirs),
              elsie::bench::median(ratios), *low, *high, memory);
  std::fflush(stdout);
}

void measure_loading(const elsie::plugin::Host& host, int repeats) {
  const auto file = std::filesystem::temp_directory_path() / "elsie-bench-world.xml";
  std::ofstream(file) << elsie::world::write_world(elsie::bench::arena_of_robots(100));
  std::vector<double> reading, making;
  for (int i = 0; i < repeats; ++i) {
    auto start = Clock::now();
    elsie::world::World read = elsie::world::read_world(file.string(), host);
    reading.push_back(1e3 * seconds(start));
    start = Clock::now();
    const elsie::simulation::Simulation simulation(std::move(read), host);
    making.push_back(1e3 * seconds(start));
  }
  std::filesystem::remove(file);
  std::printf(
      "\nA world of 100 robots with 8 beams each: read and checked in %.1f ms, put together in "
      "%.1f ms (medians of %d).\n",
      elsie::bench::median(reading), elsie::bench::median(making), repeats);
}

}  // namespace

int main(int argc, char** argv) try {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 15;
  if (repeats < 1) {
    std::fprintf(stderr, "usage: robot_steps [--repeats N]\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::printf(
      "| robots | Elsie, robot-steps/s | bare ODE, robot-steps/s | ratio | spread of the ratio | "
      "memory MiB |\n");
  std::printf("|---|---|---|---|---|---|\n");
  constexpr int kRobots[] = {1, 10, 100};
  double memory[std::size(kRobots)];
  for (std::size_t i = 0; i < std::size(kRobots); ++i) {
    memory[i] = memory_of_simulation(host, kRobots[i]);  // first: no memory is in use yet
  }
  for (std::size_t i = 0; i < std::size(kRobots); ++i) {
    compare(host, kRobots[i], repeats, memory[i]);
  }
  measure_loading(host, repeats);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
