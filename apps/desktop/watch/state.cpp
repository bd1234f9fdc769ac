#include "watch/state.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace elsie::desktop {

const Json& robot_of(const Json& state, const QString& id) {
  static const Json none;
  for (const Json& robot : member(state, "robots")) {
    if (text_of(robot, "id") == id) {
      return robot;
    }
  }
  return none;
}

std::vector<int> whole_percents(const std::vector<double>& parts) {
  std::vector<int> percents;
  std::vector<double> rest;
  double sum = 0.0;
  for (const double part : parts) {
    const double exact = std::isfinite(part) ? 100.0 * std::clamp(part, 0.0, 1.0) : 0.0;
    percents.push_back(static_cast<int>(std::floor(exact)));
    rest.push_back(exact - percents.back());
    sum += exact;
  }
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&rest](std::size_t a, std::size_t b) { return rest[a] > rest[b]; });
  const long missing = std::lround(sum) - std::accumulate(percents.begin(), percents.end(), 0L);
  for (std::size_t i = 0; i < static_cast<std::size_t>(missing); ++i) {
    ++percents[order[i]];
  }
  return percents;
}

}  // namespace elsie::desktop
