// Where everything was: what a window shows when its time line is pulled back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "elsie/snapshots/snapshots.h"
#include "elsie/traces/sampling.h"

namespace elsie::server {

/// Samples of the poses of all bodies, one each kPeriod_s. When they take more than `most`
/// bytes, every second one is dropped, and as many fewer are added from then on.
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

  /// A run from the beginning, with these bodies; the first sample is added at once.
  void begin(std::vector<std::string> names);
  /// The bodies from now on.
  void rename(std::vector<std::string> names);
  /// To be asked once for each time, in ascending order.
  bool is_due(double time_s) { return sampling_.is_due(time_s); }
  void add(double time_s, std::uint64_t steps, std::vector<snapshots::BodyState> bodies);

  double from_s() const { return samples_.empty() ? 0.0 : samples_.front().time_s; }
  std::size_t size() const { return samples_.size(); }
  /// The nearest sample; there must be one. Its bodies are the present ones: those that were not
  /// there then are not present.
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
