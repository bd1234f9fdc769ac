// Which factor matters, in one line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "elsie/report/factors.h"

namespace elsie::report {

/// How far a factor moves a response.
struct FactorEffect {
  std::string factor;
  /// The largest less the smallest of the levels' centres (see Margin), 0 if they are_equal(). None
  /// if a centre is not known.
  std::optional<double> size;
  /// Of the test by seed of these two levels, times the number of pairs of levels, because they are
  /// chosen as the farthest apart (Bonferroni); at most 1. None if nothing is random.
  std::optional<double> p;
  bool confounded = false;  // the levels differ in other factors, too

  bool may_be_chance() const { return p && *p >= 1.0 - kConfidence; }
};

struct FactorEffects {
  Response response;
  std::vector<FactorEffect> factors;  // the largest first, those that are not known last
};

/// Of success, or of the first measure if success is the same in all runs. None if nothing is
/// varied or nothing differs.
std::optional<FactorEffects> factor_effects(const Findings& findings);

/// "team size moves success by 0.62, coordinator by 0.05 (which may be chance), noise by nothing";
/// "" if there are none.
std::string effects_in_words(const Findings& findings);

}  // namespace elsie::report
