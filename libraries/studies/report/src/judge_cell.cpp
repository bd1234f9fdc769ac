#include <cmath>

#include "judging.h"
#include "words.h"

namespace elsie::report {

namespace {

std::optional<Interval> interval_of(const Judging& judging, const std::vector<double>& values) {
  return report::interval_of(judging.expectation.statistic, values, *judging.expectation.confidence,
                             judging.results.seed(), judging.stream());
}

// Judges a cell with lower bounds: its mean and maximum are also bounds. A median or minimum,
// computed with infinity instead of the bounds, is exact if it is finite.
Claim about_bounds(const Judging& judging, std::size_t cell, const std::vector<double>& bounds,
                   const std::vector<double>& infinite) {
  const Statistic statistic = judging.expectation.statistic;
  if (statistic == Statistic::standard_deviation || statistic == Statistic::rate) {
    return judging.not_known(cell, judging.stopped(cell));
  }
  const bool ordered = statistic == Statistic::median || statistic == Statistic::minimum;
  const double value = *statistic_of(statistic, ordered ? infinite : bounds);
  Claim claim;
  claim.cell = cell;
  std::string amount;
  if (std::isfinite(value) && ordered) {
    claim.value = value;
    claim.holds = judging.keeps(value);
    if (judging.expectation.confidence) {
      claim.interval = interval_of(judging, infinite);
      claim.holds = judging.keeps(claim.interval);
    }
    amount = judging.with_unit(value) + " (" + judging.basis(bounds) +
             judging.interval_in_words(claim.interval);
  } else {
    // The mean of times cut off at the limit is at most that of the true times.
    const double least = *statistic_of(statistic, bounds);
    const auto interval = judging.expectation.confidence ? interval_of(judging, bounds)
                                                         : std::optional(Interval{least, least});
    claim.holds = !judging.expectation.at_most && !judging.expectation.about && interval &&
                  judging.keeps(interval->low);
    amount = "at least " + judging.with_unit(least) + " (" + judging.basis(bounds);
  }
  claim.found = judging.subject.words + " of " + judging.label(cell) + " is " + amount + "; " +
                judging.stopped(cell) + judging.reservations(cell) + ")";
  claim.sentence = claim.found + ", expected " + judging.limits();
  return claim;
}

}  // namespace

Claim judge_cell(const Judging& judging, std::size_t cell) {
  if (const auto claim = judging.obstacle(cell, cell)) {
    return *claim;
  }
  const std::vector<double> values = judging.values_of(cell);
  if (judging.censored(cell) > 0) {
    return about_bounds(judging, cell, values, judging.values_of(cell, true));
  }
  Claim claim;
  claim.cell = cell;
  if (!values.empty()) {
    claim.value = statistic_of(judging.expectation.statistic, values);
  }
  if (!claim.value) {
    return judging.not_known(cell, judging.unknown(cell, values));
  }
  claim.holds = judging.keeps(*claim.value);
  if (judging.expectation.confidence) {
    claim.interval = interval_of(judging, values);
    claim.holds = judging.keeps(claim.interval);
  }
  claim.found = judging.subject.words + " of " + judging.label(cell) + " is " +
                judging.with_unit(*claim.value) + " (" + judging.basis(values) +
                judging.interval_in_words(claim.interval) + judging.reservations(cell) + ")";
  claim.sentence = claim.found + ", expected " + judging.limits();
  return claim;
}

}  // namespace elsie::report
