// The gain from threads within a run: the arena of growth.cpp in one thread, and in as many as
// there are processors.
//
//   threads [--repeats N] [--threads N]
//
// Wall-clock time, because that is what threads save. Both simulations of a size go on in turn.
// Prints a table in Markdown.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"

#include "arena_of_robots.h"
#include "statistics.h"

namespace {

constexpr int kWarmUp = 100;          // steps
constexpr int kStepsInAll = 400'000;  // robot-steps in one measurement, on the planar engine
constexpr int kFewest = 10;           // steps

struct Size {
  const char* engine;
  int robots;
};
constexpr Size kSizes[] = {{"planar", 100}, {"planar", 1'000}, {"planar", 10'000},
                           {"ode", 100},    {"ode", 1'000},    {"ode", 10'000}};

elsie::simulation::Simulation made(const elsie::plugin::Host& host, const Size& size,
                                   std::size_t threads) {
  elsie::world::World arena = elsie::bench::arena_of_robots(size.robots);
  arena.physics.engine = size.engine;
  elsie::simulation::Simulation simulation(std::move(arena), host, {.threads = threads});
  for (int i = 0; i < kWarmUp; ++i) simulation.step();
  return simulation;
}

/// Robot-steps per second.
double rate(elsie::simulation::Simulation& simulation, const Size& size) {
  const bool is_planar = size.engine == std::string("planar");
  const int steps = std::max(kFewest, kStepsInAll / size.robots / (is_planar ? 1 : 10));
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) simulation.step();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
  return steps * size.robots / taken.count();
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 9;
  std::size_t threads = std::max(2u, std::thread::hardware_concurrency());
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--repeats") {
      repeats = std::atoi(argv[i + 1]);
    } else if (option == "--threads") {
      threads = static_cast<std::size_t>(std::max(0, std::atoi(argv[i + 1])));
    } else {
      repeats = 0;
    }
  }
  if (argc % 2 == 0 || repeats < 1 || threads < 2) {
    std::fprintf(stderr, "usage: threads [--repeats N] [--threads N], from 2\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::printf(
      "| engine | robots | robot-steps/s, 1 thread | %zu threads | times | spread | same state "
      "|\n|---|---|---|---|---|---|---|\n",
      threads);
  for (const Size& size : kSizes) {
    auto alone = made(host, size, 1), together = made(host, size, threads);
    std::vector<double> one, several, times;
    for (int i = 0; i < repeats; ++i) {
      one.push_back(rate(alone, size));
      several.push_back(rate(together, size));
      times.push_back(several.back() / one.back());
    }
    const auto [low, high] = std::minmax_element(times.begin(), times.end());
    std::printf("| `%s` | %d | %.0f | %.0f | %.2f | %.2f to %.2f | %s |\n", size.engine,
                size.robots, elsie::bench::median(one), elsie::bench::median(several),
                elsie::bench::median(times), *low, *high,
                alone.state_hash() == together.state_hash() ? "yes" : "NO");
    std::fflush(stdout);
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "threads: %s\n", error.what());
  return 2;
}
