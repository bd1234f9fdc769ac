// The random streams and the failures of <noise> and <failure> elements.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/disturbance.h"
#include "elsie/base/random.h"

namespace elsie::simulation {

/// The disturbances of one sensor or drive.
class Disturbances {
 public:
  /// Throws std::invalid_argument with a sentence if a noise names nothing, or its clamp is no
  /// range. `names`: of the numbers that there are; `owner`: what has them, "its reading".
  static void check(const Noise& noise, const std::vector<std::string>& names,
                    const std::string& owner);

  /// Takes over what the elements say; random streams go on.
  void fit(std::span<const Disturbance> all);
  /// Called before a run; `path` is the sensor's or the drive's.
  void reset(std::uint64_t seed, const std::string& path);

  const std::vector<Noise>& noises() const { return noises_; }
  /// The value with the noise of this index. Draws from its stream. Throws base::Error with a
  /// sentence if that is not finite.
  double disturbed(std::size_t noise, double value);
  /// Whether an update is missed. Draws from the streams; call it once for each update.
  bool misses_update();
  /// Whether nothing is renewed any more.
  bool is_stuck(double time_s) const { return time_s >= stuck_from_s_; }
  double latency_s() const { return latency_s_; }

 private:
  /// Begins the streams of so many elements that have none yet. Each has one of its own, so that a
  /// new element changes nothing else; it stays when the element goes, for an edit that is undone.
  void begin(std::vector<Random>& streams, const char* element, std::size_t count) const;
  void begin_all();

  std::vector<Noise> noises_;
  std::vector<UpdateFailure> failures_;
  std::vector<Random> noise_streams_, failure_streams_;
  double latency_s_ = 0.0;
  double stuck_from_s_ = 0.0;  // infinite: never
  std::uint64_t seed_ = 0;
  std::string path_;
};

}  // namespace elsie::simulation
