// The earlier positions of all bodies, for a window that looks back in time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/snapshots/snapshots.h"

#include "samples.h"

namespace elsie::server {

/// Samples of the poses of all bodies; see Samples.
class History {
 public:
  struct Sample {
    double time_s = 0.0;
    std::uint64_t steps = 0;
    SharedNames names;  // of the bodies
    std::vector<snapshots::BodyState> bodies;

    std::size_t bytes() const {
      return sizeof(*this) + bodies.size() * sizeof(snapshots::BodyState);
    }
  };
  /// The places of a body at the times of some samples, m; NaN while it does not exist.
  struct Path {
    std::vector<float> x, y;
  };

  explicit History(std::size_t most = std::size_t{200} << 20) : samples_(most) {}

  /// Begins a new run with these bodies. The first sample must be added at once.
  void begin(std::vector<std::string> names, double period_s);
  /// Sets the names of the bodies from now on.
  void rename(std::vector<std::string> names);
  /// The present names.
  const std::vector<std::string>& names() const { return names_->names(); }
  /// Whether a sample is due. Must be called once for each time, in ascending order.
  bool is_due(double time_s) { return samples_.is_due(time_s); }
  void add(double time_s, std::uint64_t steps, std::vector<snapshots::BodyState> bodies);

  double from_s() const { return samples_.all().empty() ? 0.0 : samples_.all().front().time_s; }
  double period_s() const { return samples_.period_s(); }
  std::size_t size() const { return samples_.all().size(); }
  /// The nearest sample; at least one must exist. It lists the current bodies; those that did not
  /// exist at that time have `present` = 0.
  Sample at(double time_s) const;
  std::span<const Sample> after(double time_s) const { return samples_.after(time_s); }
  /// The paths of the bodies with these names in some samples.
  static std::vector<Path> paths(std::span<const std::string> names,
                                 std::span<const Sample> samples);

 private:
  Samples<Sample> samples_;
  SharedNames names_;
};

}  // namespace elsie::server
