// Noise and failure of sensors and drives, as data of a world file.
//
//   <beam_range>
//     <noise on="distance_m" gaussian="0.01" resolution="0.005"/>
//     <failure dropout="0.05" latency="0.1"/>
//   </beam_range>
//
// Every sensor and drive may hold these elements, whatever its plugin: the simulator applies them
// to the numbers that visit() of a reading lists, after the sensor's own noise, or to the set
// points of a drive's joints. Each <noise> and <failure> draws from a random stream of its own.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/declaration.h"

namespace elsie {

/// Noise on a number, or on each number of an array. A value v becomes w = v scale + bias, then
/// w + w proportional n1 + gaussian n2 + uniform u, rounded to a multiple of `resolution`, within
/// `clamp`; n1 and n2 are normal with deviation 1, u is uniform in [-1, 1).
struct Noise {
  std::string on;      // a field of a reading: "blobs.distance"; of a drive: "left_wheel.rate"
  double scale = 1.0;  // a factor
  double bias = 0.0;   // in the unit of the number, as the following
  double proportional = 0.0;  // standard deviation as a fraction of the value
  double gaussian = 0.0;      // standard deviation
  double uniform = 0.0;       // half the width
  double resolution = 0.0;    // 0: it is not rounded
  std::vector<double> clamp;  // the least and the greatest value; empty: no limits
};

/// How a sensor fails to renew its reading, or a drive the set points of its joints.
struct UpdateFailure {
  double dropout = 0.0;      // probability of each update to be missed: the last one holds on
  double latency = 0.0;      // s: an update takes effect so much later
  double stuck_from = -1.0;  // s: from this time on nothing is renewed; negative: never
};

using Disturbance = std::variant<Noise, UpdateFailure>;

/// Declares the elements <noise> and <failure> for a plugin whose objects keep them in this list.
void declare_disturbances(Declaration& declaration,
                          std::vector<Disturbance>& (*list_of)(Component&));

}  // namespace elsie
