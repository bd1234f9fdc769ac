// The earlier positions of all bodies, for a window that looks back in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "elsie/snapshots/snapshots.h"
#include "elsie/traces/sampling.h"

namespace elsie::server {

/// Samples of the poses of all bodies, one per kPeriod_s. When they take more than `most` bytes,
/// every second sample is dropped, and the period doubles.
class History {
 public:
  struct Sample {
    double time_s = 0.0;
    std::uint64_t steps = 0;
    std::shared_ptr<const std::vector<std::string>> names;  // of the bodies
    std::vector<snapshots::BodyState> bodies;
  };

  static constexpr double kPeriod_s = 0.05;
  explicit History(std::size_t most = std::size_t{200} << 20) : most_(most) {}

  /// Begins a new run with these bodies. The first sample must be added at once.
  void begin(std::vector<std::string> names);
  /// Sets the names of the bodies from now on.
  void rename(std::vector<std::string> names);
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return sampling_.is_due(time_s); }
  void add(double time_s, std::uint64_t steps, std::vector<snapshots::BodyState> bodies);

  double from_s() const { return samples_.empty() ? 0.0 : samples_.front().time_s; }
  std::size_t size() const { return samples_.size(); }
  /// The nearest sample; at least one must exist. It lists the current bodies; those that did not
  /// exist at that time have `present` = 0.
  Sample at(double time_s) const;

 private:
  void thin_out();

  std::size_t most_;
  std::size_t bytes_ = 0;
  traces::Sampling sampling_{kPeriod_s};
  std::shared_ptr<const std::vector<std::string>> names_;
  std::vector<Sample> samples_;  // ascending in time
};

}  // namespace elsie::server
