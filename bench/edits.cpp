// What an edit of a running world costs among many robots, against the same edit among few; and
// what edits that a world makes itself cost, each, when there are many, against few. In processor
// time. Prints tables in Markdown.
//
//   edits [--repeats N]
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <functional>
#include <string>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/search_path.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/reader.h"

#include "arena_of_robots.h"
#include "statistics.h"

namespace {

using elsie::bench::median;
using elsie::simulation::Simulation;

constexpr int kFew = 10;
constexpr int kSizes[] = {kFew, 1'000, 10'000, 100'000};  // robots
constexpr int kFewChanges = 80, kManyChanges = 8'000;

double seconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

struct Edit {
  const char* name;
  std::function<void(Simulation&, int)> make;  // the n-th
};

std::vector<Edit> edits() {
  const auto first = [](const Simulation& run) {
    return "robot[" + run.world().robots[0].id + "]";
  };
  return {
      {"an attribute in place",
       [=](Simulation& run, int n) {
         run.edit(first(run) + "/@max_speed", n % 2 == 0 ? "0.3" : "0.4");
       }},
      {"one of each robot in turn, in place",
       [=](Simulation& run, int n) {
         const auto& robots = run.world().robots;
         const auto robot = static_cast<std::size_t>(n) % robots.size();
         run.edit("robot[" + robots[robot].id + "]/@coverage", "0.7");
       }},
      {"a behaviour's element",
       [=](Simulation& run, int n) {
         run.edit(first(run) + "/behavior[" + run.world().robots[0].behaviors[0].id + "]",
                  n % 2 == 0 ? "<wander/>" : "<wander restlessness=\"2\"/>");
       }},
      {"the world's name", [](Simulation& run, int n) { run.edit("@name", std::to_string(n)); }}};
}

/// A world of one robot with so many edits, each at its time.
std::string edited_world(int changes, bool in_place) {
  std::string all;
  for (int i = 0; i < changes; ++i) {
    const std::string begin = "<change time=\"" + std::to_string(0.01 * i) + "\" path=\"robot[r1]/";
    all += in_place ? begin + "@max_speed\" value=\"0." + std::to_string(1 + i % 5) + "\"/>"
                    : begin + "behavior[wander]\"><wander restlessness=\"" +
                          std::to_string(1 + i % 5) + "\"/></change>";
  }
  return "<world format=\"1\"><robots><robot id=\"r1\"><behaviors><wander/></behaviors>"
         "<coordinator><arbiter_suppression/></coordinator></robot></robots><changes>" +
         all + "</changes><limits time=\"100\"/></world>";
}

/// Seconds to read and check such a world, for each edit.
double cost_of_changes(const elsie::plugin::Host& host, int changes, bool in_place) {
  elsie::world::ReadOptions options;
  options.check_plugins = true;
  return seconds([&] {
           const auto world = elsie::world::parse_world(edited_world(changes, in_place),
                                                        "changes.xml", host, options);
           Simulation(world, host).check({});
         }) /
         changes;
}

void print_edits(const elsie::plugin::Host& host, int repeats) {
  std::printf("| robots | edit | ms | against %d robots |\n|---|---|---|---|\n", kFew);
  const std::vector<Edit> all = edits();
  std::vector<double> few(all.size());
  for (const int robots : kSizes) {
    elsie::world::World arena = elsie::bench::arena_of_robots(robots);
    arena.physics.engine = "planar";
    Simulation run(std::move(arena), host);
    for (std::size_t k = 0; k < all.size(); ++k) {
      std::vector<double> times;
      for (int i = 0; i <= repeats; ++i) {
        const double time = seconds([&] { all[k].make(run, i); });
        if (i > 0) times.push_back(time);
      }
      if (robots == kFew) few[k] = median(times);
      std::printf("| %d | %s | %.2f | %.0f |\n", robots, all[k].name, 1e3 * median(times),
                  median(times) / few[k]);
    }
  }
}

void print_changes(const elsie::plugin::Host& host) {
  std::printf("\n| edits of one world | ms each | against %d |\n|---|---|---|\n", kFewChanges);
  for (const bool in_place : {true, false}) {
    const double few = cost_of_changes(host, kFewChanges, in_place);
    const double many = cost_of_changes(host, kManyChanges, in_place);
    std::printf("| %d %s | %.3f | %.2f |\n", kManyChanges, in_place ? "in place" : "of behaviours",
                1e3 * many, many / few);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 5;
  if ((argc != 1 && argc != 3) || repeats < 1) {
    std::fprintf(stderr, "usage: edits [--repeats N]\n");
    return EXIT_FAILURE;
  }
  try {
    const elsie::plugin::Host host(elsie::plugin::default_search_path());
    print_edits(host, repeats);
    print_changes(host);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "edits: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
