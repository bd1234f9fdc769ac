// Times that a limit cuts off.
#include <cmath>

#include <catch2/catch.hpp>

#include "elsie/report/survival.h"

using namespace elsie::report;

namespace {

std::vector<Observed> known_times(std::initializer_list<double> times) {
  std::vector<Observed> all;
  for (const double time : times) all.push_back({time, false});
  return all;
}

// Remission of leukaemia in weeks under 6-mercaptopurine (Freireich and others 1963, as in Gehan
// 1965): the standard example of survival analysis.
std::vector<Observed> remissions() {
  return {{6, false},  {6, false},  {6, false},  {6, true},   {7, false}, {9, true},  {10, false},
          {10, true},  {11, true},  {13, false}, {16, false}, {17, true}, {19, true}, {20, true},
          {22, false}, {23, false}, {25, true},  {32, true},  {32, true}, {34, true}, {35, true}};
}

}  // namespace

TEST_CASE("The curve of the remissions of Freireich is the published one, with its intervals") {
  // Curve and numbers at risk from Kalbfleisch and Prentice (1980), intervals by Stata's sts list.
  struct Row {
    double time;
    std::size_t at_risk, events;
    double survival, low, high;
  };
  const Row rows[] = {{6, 21, 3, 0.8571, 0.6197, 0.9516},  {7, 17, 1, 0.8067, 0.5631, 0.9228},
                      {10, 15, 1, 0.7529, 0.5032, 0.8894}, {13, 12, 1, 0.6902, 0.4316, 0.8491},
                      {16, 11, 1, 0.6275, 0.3675, 0.8049}, {22, 7, 1, 0.5378, 0.2678, 0.7468},
                      {23, 6, 1, 0.4482, 0.1881, 0.6801}};
  const SurvivalCurve curve = survival_of(remissions(), 0.95);
  std::size_t next = 0;
  for (const SurvivalStep& step : curve.steps) {
    if (step.events == 0) continue;
    REQUIRE(next < std::size(rows));
    CHECK(step.time == rows[next].time);
    CHECK(step.at_risk == rows[next].at_risk);
    CHECK(step.events == rows[next].events);
    CHECK(step.survival == Approx(rows[next].survival).margin(6e-5));
    CHECK(step.interval.low == Approx(rows[next].low).margin(6e-5));
    CHECK(step.interval.high == Approx(rows[next].high).margin(6e-5));
    ++next;
  }
  CHECK(next == std::size(rows));
  CHECK(curve.median == 23.0);
  // statsmodels 0.13, quantile_ci(0.5, method="cloglog"): (13, inf).
  REQUIRE(curve.median_interval);
  CHECK(curve.median_interval->low == 13.0);
  CHECK(std::isinf(curve.median_interval->high));
}

TEST_CASE("Bounds at the time of an event are still at risk then") {
  const std::vector<Observed> times{{1, false}, {2, true}, {2, false}, {3, false}};
  const SurvivalCurve curve = survival_of(times, 0.95);
  REQUIRE(curve.steps.size() == 3);
  CHECK(curve.steps[1].at_risk == 3);
  CHECK(curve.steps[1].cut_off == 1);
  CHECK(curve.steps[1].survival == Approx(0.5));  // 3/4 * 2/3
  CHECK(curve.at_risk(0.0) == 4);
  CHECK(curve.at_risk(2.0) == 3);
  CHECK(curve.at_risk(2.5) == 1);
  CHECK(curve.at_risk(4.0) == 0);
}

TEST_CASE("Without bounds the curve is the plain distribution, and the median the usual one") {
  CHECK(survival_of(known_times({4, 1, 3, 2}), 0.95).median == 2.5);
  CHECK(survival_of(known_times({5, 1, 3}), 0.95).median == 3.0);
  CHECK(survival_of(known_times({7}), 0.95).median == 7.0);
  CHECK(survival_of(known_times({7, 7, 7}), 0.95).median == 7.0);
}

TEST_CASE("The median is unknown when more than half remain, and when half remain to the end") {
  const std::vector<Observed> most{{1, false}, {9, true}, {9, true}};
  const std::vector<Observed> half{{1, false}, {9, true}};
  const std::vector<Observed> none{{9, true}, {9, true}};
  CHECK_FALSE(survival_of(most, 0.95).median);
  CHECK_FALSE(survival_of(half, 0.95).median);
  const SurvivalCurve flat = survival_of(none, 0.95);
  CHECK_FALSE(flat.median);
  CHECK_FALSE(flat.median_interval);
  CHECK(flat.steps.back().survival == 1.0);
}
