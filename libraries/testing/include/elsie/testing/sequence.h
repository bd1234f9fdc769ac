// A robot's perception over time.
#pragma once

#include <functional>
#include <vector>

#include "elsie/testing/situation.h"

namespace elsie::testing {

/// Instants from time zero, a control period apart:
///
///   Sequence way;
///   way.hold(0.5, Situation().beam(0, 1.0))                      // half a second of nothing
///      .change(1.0, [](double t) { return Situation().beam(0, 1.0 - 0.9 * t); });
class Sequence {
 public:
  explicit Sequence(double period_s = 0.01) : period_s_(period_s) {}

  /// Adds a constant part of this duration.
  Sequence& hold(double seconds, const Situation& now);
  /// Adds a changing part: `at` is called for each instant with the time since the part began.
  Sequence& change(double seconds, const std::function<Situation(double elapsed_s)>& at);

  double period_s() const { return period_s_; }
  /// The instants with their times and periods.
  const std::vector<Situation>& instants() const { return instants_; }

 private:
  double period_s_;
  std::vector<Situation> instants_;
};

}  // namespace elsie::testing
