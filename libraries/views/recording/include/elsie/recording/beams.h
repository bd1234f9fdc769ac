// The rays and volumes of range and proximity sensors, for pictures.
#pragma once

#include <cstddef>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/sensor.h"
#include "elsie/simulation/simulation.h"

namespace elsie::recording {

/// The ray of a range sensor, in the world.
struct RangeBeam {
  Vector3 from;
  Vector3 to;  // where it hit, or the end of its range
  bool hit = false;
};

/// The rays of a robot's last readings, from the current places of its sensors, in the order of its
/// range sensors.
std::vector<RangeBeam> range_beams(const simulation::Simulation& simulation, std::size_t robot);

}  // namespace elsie::recording
