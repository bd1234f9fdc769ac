// What every run is measured by.
#pragma once

#include <string>
#include <vector>

namespace elsie::experiment {

struct Measure {
  std::string name;     // "path_length_m"
  std::string unit;     // "" when it has none
  std::string meaning;  // a few words
};

/// In the order in which they are shown.
const std::vector<Measure>& measures_of_every_run();

}  // namespace elsie::experiment
