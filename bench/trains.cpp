// The cost of a simulated second of a robot that pulls segments to the left and right, for growing
// trains: in processor time of the engine `ode`, and per segment relative to the shortest train.
// One process, one core. Prints a table in Markdown.
//
//   trains [--repeats N]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/world/parts.h"

#include "statistics.h"

namespace {

using namespace elsie;

constexpr double kStart = 3.0;     // s, until the train is on its way
constexpr double kMeasured = 4.0;  // s, simulated: a curve to either side

/// Processor seconds for a simulated second.
double cost(std::size_t segments) {
  world::Arena field;
  field.length = field.width = 200.0;
  field.walls = false;
  const world::Physics physics;
  const auto engine = physics::make_engine(field, physics);
  engine->add_robot(world::plan_of({}, std::vector<world::Segment>(segments)), {});
  const auto run = [&](double from, double to) {
    for (long i = std::lround(from / physics.step); i < std::lround(to / physics.step); ++i) {
      const bool to_the_left = std::fmod(static_cast<double>(i) * physics.step, 4.0) < 2.0;
      const std::vector<JointSetting> rates{{to_the_left ? 14.0 : 20.0},
                                            {to_the_left ? 20.0 : 14.0}};
      engine->set_joints(0, rates);
      engine->step();
    }
  };
  run(0.0, kStart);
  const std::clock_t start = std::clock();
  run(kStart, kStart + kMeasured);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / kMeasured;
}

}  // namespace

int main(int argc, char** argv) {
  const int repeats = argc == 3 && std::string(argv[1]) == "--repeats" ? std::atoi(argv[2]) : 5;
  if ((argc != 1 && argc != 3) || repeats < 1) {
    std::fprintf(stderr, "usage: trains [--repeats N]\n");
    return EXIT_FAILURE;
  }
  try {
    const std::vector<std::size_t> sizes{25, 50, 100, 200};
    std::vector<std::vector<double>> costs(sizes.size());
    for (int i = 0; i < repeats; ++i) {  // in turn, because machines drift
      for (std::size_t k = 0; k < sizes.size(); ++k) costs[k].push_back(cost(sizes[k]));
    }
    std::printf(
        "| segments | s for a simulated second | times real time | for each segment, against %zu "
        "segments |\n|---|---|---|---|\n",
        sizes[0]);
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const double time = bench::median(costs[k]);
      std::vector<double> ratios;
      for (std::size_t i = 0; i < costs[k].size(); ++i) {
        ratios.push_back(costs[k][i] / costs[0][i] * static_cast<double>(sizes[0]) /
                         static_cast<double>(sizes[k]));
      }
      std::printf("| %zu | %.3f | %.1f | %.2f |\n", sizes[k], time, 1.0 / time,
                  bench::median(ratios));
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "trains: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
