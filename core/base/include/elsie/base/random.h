// A stream of random numbers.
#pragma once

#include <cstdint>
#include <string_view>

namespace elsie {

/// Every sensor, behaviour and network has its own stream, derived from the run's seed and the
/// owner's path in the world, so that a new sensor does not change another one's noise. The numbers
/// do not depend on the standard library (normal() depends on the C library's log and cos).
/// Generator: xoshiro256++ (Blackman and Vigna, 2018), seeded through splitmix64 (Steele, Lea and
/// Flood, 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed = 0);
  /// The stream of the owner at `path` in the run with this seed.
  Random(std::uint64_t seed, std::string_view path);

  std::uint64_t bits();
  /// In [0, 1).
  double uniform();
  /// In [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// True with the given probability; never for 0 or less, always for 1 or more.
  bool chance(double probability) { return uniform() < probability; }
  /// Normally distributed (Box and Muller, 1958).
  double normal(double mean = 0.0, double standard_deviation = 1.0);

 private:
  std::uint64_t state_[4];
};

}  // namespace elsie
