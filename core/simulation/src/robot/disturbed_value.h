// The noise and the failures that a world file gives a sensor or an actuator.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/disturbance.h"

#include "robot/disturbances.h"

namespace elsie::simulation {

/// Computes a sensor's reading from its measurement, or the command that an actuator carries out
/// from the one that a behaviour gave, for an object whose element has <noise> or <failure>.
class DisturbedValue {
 public:
  /// Throws std::invalid_argument with a sentence if a disturbance does not fit the object.
  /// `others`: numbers for disturbed(), besides those of the object.
  static void check(const Disturbable& object, const std::vector<std::string>& others = {});

  /// Takes over the object's disturbances; random streams go on. `has_other_sizes`: see
  /// Disturbable::fit_value(). Requires check().
  void fit(const Disturbable& object, bool has_other_sizes);
  /// Called before a run; `path` is the object's.
  void reset(std::uint64_t seed, const std::string& path);
  /// Called after each update of what is undisturbed: changes the present value.
  /// `is_new`: it was given since the last update. Returns whether such a one has become present.
  bool update(Disturbable& object, double time_s, double period_s, bool is_new = true);
  /// Returns a number that is not one of the object's with all noise on this name. Throws
  /// base::Error with a sentence if it is not finite.
  double disturbed(std::string_view name, double value);
  /// Forgets the values that are late, also their memory.
  void forget() {
    samples_.clear();
    spare_.clear();
  }
  /// Keeps the values that are late for a newer object, in its memory, if they fit; else forgets
  /// them.
  void renew(const Disturbable& object, bool fits);
  /// Called instead while there are no updates.
  void wait(double period_s) { age_s_ += period_s; }
  /// How old the present value is, s; infinite before the first.
  double age_s() const { return age_s_; }

 private:
  struct Sample {
    double time_s = 0.0;
    std::shared_ptr<void> value;
    bool is_new = true;
  };

  void add_noise(Disturbable& object, const void* value);
  /// The memory for another sample.
  std::shared_ptr<void> memory(const Disturbable& object);

  Disturbances disturbances_;
  std::vector<std::vector<std::size_t>> fields_;  // of each noise: their places in visit()
  std::deque<Sample> samples_;                    // that are not due yet
  std::vector<std::shared_ptr<void>> spare_;
  double age_s_ = 0.0;
};

}  // namespace elsie::simulation
