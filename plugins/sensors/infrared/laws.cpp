#include "laws.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>

namespace infrared {
namespace {

struct Point {
  double distance_m;
  double value;
};

/// The straight line between the points of a table; the value of its first point in front of it.
template <std::size_t kCount>
double between(const Point (&table)[kCount], double distance_m) {
  if (distance_m <= table[0].distance_m) return table[0].value;
  for (std::size_t i = 1; i < kCount; ++i) {
    if (distance_m > table[i].distance_m) continue;
    const Point &a = table[i - 1], &b = table[i];
    const double part = (distance_m - a.distance_m) / (b.distance_m - a.distance_m);
    return a.value + part * (b.value - a.value);
  }
  return 0.0;
}

double khepera(double distance_m) {
  static constexpr Point kWhitePaper[] = {{0.01, 1000}, {0.02, 450}, {0.03, 275}, {0.04, 190},
                                          {0.05, 150},  {0.06, 125}, {0.08, 100}, {0.1, 80}};
  return between(kWhitePaper, distance_m);
}

double khepera_iv(double distance_m) {
  return distance_m < 0.04 ? 1.0
                           : std::clamp(4.14 * std::exp(-33.0 * distance_m) - 0.085, 0.0, 1.0);
}

double epuck(double distance_m) {
  return std::clamp(298.701 * distance_m * distance_m - 36.8961 * distance_m + 1.08212, 0.0, 1.0);
}

double footbot(double distance_m) {
  return distance_m < 0.00989 ? 1.0 : 0.0100527 / (distance_m + 0.000163144);
}

/// Enki's Khepera; its lengths are in cm.
constexpr double enki(double distance_m) {
  constexpr double m = 1200.0, x0 = -0.9, c = 7.0;
  const double d = 100.0 * distance_m;
  return m * (c - x0 * x0) / (d * d - 2.0 * x0 * d + c);
}
constexpr double kEnkiLargest = enki(0.0);

constexpr Law kLaws[] = {
    {"khepera", 1000.0, 0.1, khepera, "Khepera II, white paper: K-Team's user manual"},
    {"khepera_iv", 1.0, 0.12, khepera_iv, "Khepera IV: ARGoS"},
    {"epuck", 1.0, 0.05, epuck, "e-puck: ARGoS"},
    {"footbot", 1.0, 0.1, footbot, "foot-bot: ARGoS"},
    {"enki", kEnkiLargest, 0.1, enki, "Khepera: Enki"},
};

}  // namespace

const Law& law_of(const std::string& name) {
  const auto found = std::find_if(std::begin(kLaws), std::end(kLaws),
                                  [&](const Law& law) { return law.name == name; });
  if (found == std::end(kLaws)) throw std::invalid_argument("there is no law '" + name + "'");
  return *found;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const Law& law : kLaws) {
    names.emplace_back(law.name);
  }
  return names;
}

}  // namespace infrared
