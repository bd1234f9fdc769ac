// The noise and the failures that a world file gives a sensor.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "elsie/api/sensor.h"

#include "robot/disturbances.h"

namespace elsie::simulation {

/// Makes a sensor's reading of what it measures, for one sensor whose element has <noise> or
/// <failure>. The sensor itself goes on as without them.
class DisturbedReading {
 public:
  /// Throws std::invalid_argument with a sentence if a disturbance does not fit the sensor.
  static void check(const Sensor& sensor);

  /// Takes over the sensor's disturbances; random streams go on. `has_other_sizes`: see
  /// Sensor::fit_reading(). Requires check().
  void fit(const Sensor& sensor, bool has_other_sizes);
  /// Called before a run; `path` is the sensor's.
  void reset(std::uint64_t seed, const std::string& path);
  /// Called after each update of the sensor: changes its current reading.
  void update(Sensor& sensor, double time_s, double period_s);
  /// Called instead while the sensor is not updated.
  void wait(double period_s) { age_s_ += period_s; }
  /// How long ago the current reading was measured, s; infinite if nothing was measured yet.
  double age_s() const { return age_s_; }

 private:
  struct Sample {
    double time_s = 0.0;
    std::shared_ptr<void> reading;
  };

  void add_noise(Sensor& sensor, const void* reading);
  /// The memory for another sample.
  std::shared_ptr<void> memory(const Sensor& sensor);

  Disturbances disturbances_;
  std::vector<std::vector<std::size_t>> fields_;  // of each noise: their places in visit()
  std::deque<Sample> samples_;  // measured and not seen yet, the first of them last seen
  std::vector<std::shared_ptr<void>> spare_;
  double age_s_ = 0.0;
};

}  // namespace elsie::simulation
