// Times that a limit cuts off: the estimate of Kaplan and Meier (1958).
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "elsie/report/statistics.h"

namespace elsie::report {

/// A value that is known, or of which only a lower bound is.
struct Observed {
  double value = 0.0;
  bool bound = false;  // the true value is larger
};

/// The curve just after a time at which something happened.
struct SurvivalStep {
  double time = 0.0;
  std::size_t at_risk = 0;  // just before
  std::size_t events = 0;
  std::size_t cut_off = 0;  // bounds at this time; they count as at risk for the events
  double survival = 1.0;    // the part whose time is longer
  Interval interval{0.0, 1.0};
};

struct SurvivalCurve {
  std::vector<SurvivalStep> steps;  // one for each different time, ascending
  /// The first time after which at most half remain; where exactly half remain for a while, the
  /// middle of that while. None when more than half remain at the end.
  std::optional<double> median;
  /// Brookmeyer and Crowley (1982): the times at which the intervals of the curve contain one half.
  /// The upper end may be infinite: it is then not below the last time.
  std::optional<Interval> median_interval;

  /// How many are under observation just before this time.
  std::size_t at_risk(double time) const;
};

/// The curve of a sample that is not empty. The intervals of its points are those of Greenwood
/// (1926) for log(-log) of the curve, which stay between 0 and 1 (Kalbfleisch and Prentice 1980);
/// `confidence` in (0, 1). Before the first event and where none remains, an interval is the point.
/// `copies`: how many of the times are one observation, on average; it multiplies the variance.
SurvivalCurve survival_of(std::span<const Observed> times, double confidence, double copies = 1.0);

}  // namespace elsie::report
