// What reading a world of many robots costs, and the memory of a robot: its description, and what a
// simulation adds to it.
//
//   footprint [--repeats N] [--most N]
//
// World: worlds/scattered/swarm.xml in arenas of growing size. Each measurement is made in a
// process of its own, which has no freed memory to reuse. Prints a table in Markdown.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include "elsie/plugin/host.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "apart.h"
#include "statistics.h"

namespace {

constexpr int kSteps = 100;
constexpr int kMostOnOde = 10'000;  // robots

struct Footprint {
  double robots = 0.0;
  double reading_s = 0.0, making_s = 0.0;
  double most_bytes = 0.0;  // of the process while it reads
  double described_bytes = 0.0, simulated_bytes = 0.0;
};

/// Processor time.
double seconds(std::clock_t since) {
  return static_cast<double>(std::clock() - since) / CLOCKS_PER_SEC;
}

double bytes_in_use() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double total_pages = 0.0, resident_pages = 0.0;
  statm >> total_pages >> resident_pages;
  return resident_pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double most_bytes_so_far() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

Footprint measure(const elsie::plugin::Host& host, const std::string& engine, int robots) {
  elsie::world::ReadOptions options;
  options.data_directories = {ELSIE_SOURCE_DIR};
  const std::string side = std::to_string(std::sqrt(robots));  // m: one robot for each m^2
  options.edits = {"arena/@length=" + side, "arena/@width=" + side, "physics/@engine=" + engine};
  Footprint found;
  const double before = bytes_in_use();
  std::clock_t start = std::clock();
  elsie::world::World world =
      elsie::world::read_world(ELSIE_SOURCE_DIR "/worlds/scattered/swarm.xml", host, options);
  found.reading_s = seconds(start);
  found.most_bytes = most_bytes_so_far();
  found.robots = static_cast<double>(world.robots.size());
  const double described = bytes_in_use();
  found.described_bytes = described - before;
  start = std::clock();
  elsie::simulation::Simulation simulation(std::move(world), host);
  found.making_s = seconds(start);
  for (int i = 0; i < kSteps; ++i) simulation.step();
  found.simulated_bytes = bytes_in_use() - described;
  return found;
}

double median_of(const std::vector<Footprint>& all, double Footprint::*figure) {
  std::vector<double> values;
  for (const Footprint& each : all) values.push_back(each.*figure);
  return elsie::bench::median(values);
}

}  // namespace

int main(int argc, char** argv) try {
  int repeats = 3, most = 100'000;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i];
    if (option == "--repeats") {
      repeats = std::atoi(argv[i + 1]);
    } else if (option == "--most") {
      most = std::atoi(argv[i + 1]);
    } else {
      repeats = 0;
    }
  }
  if (argc % 2 == 0 || repeats < 1 || most < 1) {
    std::fprintf(stderr, "usage: footprint [--repeats N] [--most N]\n");
    return 2;
  }
  const elsie::plugin::Host host(elsie::plugin::default_search_path());
  std::printf(
      "| engine | robots | read and checked, ms | put together, ms | description, B a robot | "
      "simulation, B a robot | most while reading, MiB |\n|---|---|---|---|---|---|---|\n");
  for (const char* engine : {"planar", "ode"}) {
    for (int robots = 100; robots <= most; robots *= 10) {
      if (engine == std::string("ode") && robots > kMostOnOde) continue;
      std::vector<Footprint> all;
      for (int i = 0; i < repeats; ++i)
        all.push_back(elsie::bench::apart([&] { return measure(host, engine, robots); }));
      const double count = all.front().robots;
      std::printf("| `%s` | %.0f | %.1f | %.1f | %.0f | %.0f | %.0f |\n", engine, count,
                  1e3 * median_of(all, &Footprint::reading_s),
                  1e3 * median_of(all, &Footprint::making_s),
                  median_of(all, &Footprint::described_bytes) / count,
                  median_of(all, &Footprint::simulated_bytes) / count,
                  median_of(all, &Footprint::most_bytes) / (1024.0 * 1024.0));
      std::fflush(stdout);
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "footprint: %s\n", error.what());
  return 2;
}
