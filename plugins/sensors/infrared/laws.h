// Value against distance of the infra-red sensors of known robots.
#pragma once

#include <string>
#include <vector>

namespace infrared {

struct Law {
  const char* name;
  double largest;      // value
  double max_range_m;  // beyond it, the value is that of nothing
  double (*value)(double distance_m);
  const char* source;
};

/// The law of this name. Throws std::invalid_argument.
const Law& law_of(const std::string& name);
std::vector<std::string> law_names();

}  // namespace infrared
