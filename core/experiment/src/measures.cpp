#include "elsie/experiment/measures.h"

namespace elsie::experiment {

const std::vector<Measure>& measures_of_every_run() {
  static const std::vector<Measure> measures = {
      {"success", "", "1 when all goals were reached, else 0"},
      {"time_s", "s", "simulated time until the run ended"},
      {"path_length_m", "m", "how far all robots drove, together"},
      {"collected", "", "resources that were collected"},
      {"collisions", "", "touches with walls, obstacles and robots"},
      {"energy_left", "units", "in the batteries of all robots at the end"},
  };
  return measures;
}

}  // namespace elsie::experiment
