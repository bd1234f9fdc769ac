// A made-up study of two factors: three speeds, whose labels are numbers, and two coordinators.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>

#include "made_up.h"

namespace elsie::test {

/// The path of a run is 10 m, less 20 m for each m/s, plus 2 m of fusion, plus 0.1 m a seed. The
/// fast runs of arbitration with odd seeds reach the limit of 100 s; all others take
/// 10 s / speed / 2 + the seed.
inline MadeExperiment by_factor(std::uint64_t seeds = 6) {
  MadeExperiment study;
  study.name = "Speed & coordination";
  study.factors = {"world", "speed", "coordinator"};
  for (const std::string speed : {"0.4", "0.1", "0.2"}) {
    for (const std::string coordinator : {"arbitration", "fusion"}) {
      MadeCell& cell = study.cells.emplace_back();
      cell.label = speed + ", " + coordinator;
      cell.levels = {"w", speed, coordinator};
      cell.world_text = made_world();
      for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        MadeRun& run = cell.runs.emplace_back();
        run.seed = seed;
        const double metres = std::stod(speed);
        const bool late = speed == "0.4" && coordinator == "arbitration" && seed % 2 == 1;
        run.outcome = late ? "time_limit" : "success";
        const auto number = static_cast<double>(seed);
        run.measures = {{"success", late ? 0.0 : 1.0},
                        {"path_length_m", 10.0 - 20.0 * metres +
                                              (coordinator == "fusion" ? 2.0 : 0.0) + 0.1 * number},
                        {"time_s", late ? 100.0 : 5.0 / metres + number},
                        {"collisions", 0.0}};
        run.robots.emplace_back().poses = {{0, 0, 0}, {1, 0, 0}, {1, 0.1 * number, 1.57}};
      }
    }
  }
  return study;
}

}  // namespace elsie::test
