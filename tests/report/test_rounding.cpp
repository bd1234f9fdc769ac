// Values that differ by rounding only.
#include <limits>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "by_factor.h"
#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

TEST_CASE("Differences from rounding are no effect") {
  const std::vector<double> ones{1.0, 1.0 + 1e-14, 1.0, 1.0 - 2e-14, 1.0, 1.0};
  const std::vector<double> metres{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const auto compared = [](std::vector<double> values, double more) {
    MadeExperiment study = made_from({values, values});
    for (auto& run : study.cells[1].runs) run.measures["path_length_m"].value() += more;
    const Findings findings = Made(study).findings();
    return level_contrasts(findings, response_of(findings, "path_length_m")).front();
  };
  const std::string note =
      "differences of less than a millionth of the values come from rounding, and count as 0";
  SECTION("all runs have one value") {
    const Contrast one = compared(ones, 1e-7);
    CHECK(one.equal);
    CHECK(one.difference == 0.0);
    CHECK(one.effect.value == 0.0);
    CHECK_FALSE(one.g);
    CHECK(one.paired.p == 1.0);
    CHECK(one.pooled_p == 1.0);
    CHECK_THAT(one.notes, Catch::VectorContains(note));
    CHECK(contrast_table({one}, false)[1][2] == "equal");
    const Made alike(made_from({{1.0, 1.0, 1.0}, {1.0 + 1e-7, 1.0, 1.0}}));
    CHECK_THAT(refusal(alike.findings(), {{}, {{"a", "b"}}, {}}),
               Contains("have equal values, up to rounding, so there is nothing to compare"));
  }
  SECTION("seeds differ") {
    const Contrast one = compared(metres, 1e-7);
    CHECK_FALSE(one.equal);
    CHECK(one.difference == 0.0);
    CHECK(one.effect.value == 0.0);
    CHECK(one.paired.p == 1.0);
    CHECK(one.pooled_p == Approx(1.0));
    CHECK_THAT(one.notes, Catch::VectorContains(note));
  }
  SECTION("a difference is known, and only the spread is rounding") {
    const Contrast one = compared(ones, 1.0);
    CHECK_FALSE(one.equal);
    CHECK(one.difference == Approx(1.0));
    CHECK(one.effect.value == 1.0);
    CHECK_FALSE(one.g);  // it would be 1e14
    CHECK(one.paired.p == Approx(2.0 / 64.0));
    CHECK(one.notes.empty());
  }
  SECTION("a ten-thousandth is an effect") {
    const Contrast one = compared(metres, 1e-4);
    CHECK(one.difference == Approx(1e-4));
    CHECK(one.paired.p == Approx(2.0 / 64.0));
    CHECK(one.notes.empty());
  }
}

TEST_CASE("Infinite values are equal to themselves only") {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  CHECK(are_equal(kInfinite, kInfinite));
  CHECK_FALSE(are_equal(1.0, kInfinite));
  CHECK_FALSE(are_equal(-kInfinite, kInfinite));
}

TEST_CASE("A model whose residuals are rounding says that its p-values mean nothing") {
  MadeExperiment study = made_from({{1.0, 1.0 + 1e-14, 1.0}, {1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}});
  for (auto& run : study.cells[1].runs) run.measures["path_length_m"].value() += 1e-7;
  const Made made(study);
  CHECK_THAT(factor_model(made.findings(), "path_length_m ~ scheme").warnings,
             Catch::VectorContains(std::string("the residuals come from rounding, so errors, "
                                               "intervals and p-values mean nothing")));
}
