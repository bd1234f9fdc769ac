// Which runs views by factor and comparisons count.
#include <catch2/catch.hpp>

#include "by_factor.h"
#include "fixture.h"

using namespace elsie::report;
using elsie::test::by_factor;
using elsie::test::Made;
using elsie::test::MadeCell;
using elsie::test::MadeExperiment;

namespace {

Contrast contrast_of(const Findings& findings, const std::string& measure, const std::string& first,
                     const std::string& second) {
  for (const Contrast& one : compare(findings, first, second)) {
    if (one.response.name == measure) return one;
  }
  FAIL("there is no contrast of " + measure);
  return {};
}

}  // namespace

TEST_CASE("The rounding of means is no difference between two groups") {
  // The three differences are -0.1, 0.4 and -0.3: their sum is 0 but for rounding.
  MadeExperiment study = by_factor(12);
  const double paths[2][3] = {{0.1, 0.7, 0.3}, {0.2, 0.3, 0.6}};
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    for (auto& run : study.cells[i].runs) {
      run.measures["path_length_m"] = paths[i % 2][i / 2];
      run.measures["time_s"] = 10.0 + static_cast<double>(i);
    }
  }
  const Made made(study);
  const Contrast path = contrast_of(made.findings(), "path_length_m", "coordinator=fusion",
                                    "coordinator=arbitration");
  CHECK(path.seeds == 12);
  CHECK(path.difference == 0.0);
  CHECK(path.paired.above + path.paired.below == 0);
  CHECK(path.paired.p == 1.0);
}
