#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "fixture.h"

using namespace elsie::report;
using namespace elsie::test;

TEST_CASE("A cell's measures are summed up over its runs") {
  const Made made(made_from({{1, 2, 3, 4, 5}, {10, 10, 10, 10, 10}}));
  const Findings findings = made.findings();
  REQUIRE(findings.cells.size() == 2);
  REQUIRE(findings.measures.size() == 1);  // success has a column of its own
  const MeasureFindings& first = findings.cells[0].measures[0];
  CHECK(first.all->mean == 3.0);
  CHECK(first.all->median == 3.0);
  CHECK(first.all->standard_deviation == std::sqrt(2.5));
  CHECK(first.interval->low < 3.0);
  CHECK(first.interval->high > 3.0);
  CHECK(findings.cells[1].measures[0].interval == Interval{10.0, 10.0});
  CHECK(findings.cells[0].successes == 5);
  CHECK(findings.cells[0].complete());
  CHECK(findings.good());
}

TEST_CASE("Runs that ended abnormally are no success and have no values") {
  MadeExperiment made_up = made_from({{1, 2, 3, 4}});
  elsie::test::MadeRun& crash = made_up.cells[0].runs[3];
  crash.state = "crash";
  crash.signal = "SIGSEGV";
  crash.measures.clear();
  const Made made(made_up);
  const Findings findings = made.findings();
  const CellFindings& cell = findings.cells[0];
  CHECK(cell.ended == 4);
  CHECK(cell.successes == 3);
  CHECK(cell.broken == std::vector<std::size_t>{3});
  CHECK(cell.measures[0].all->count == 3);
  CHECK(cell.measures[0].all->mean == 2.0);
  CHECK_FALSE(findings.good());
}

TEST_CASE("A run that is still to be done makes its cell incomplete") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {4, 5, 6}});
  made_up.cells[1].runs[0].end_as("pending");
  const Made made(made_up);
  const Findings findings = made.findings();
  CHECK(findings.pending() == 1);
  CHECK(findings.cells[0].complete());
  CHECK_FALSE(findings.cells[1].complete());
  CHECK(findings.cells[1].ended == 2);
  CHECK_FALSE(findings.good());
}

TEST_CASE("A repetition of a seed is no second observation") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  for (int i = 0; i < 3; ++i) {
    elsie::test::MadeRun again = made_up.cells[0].runs[static_cast<std::size_t>(i)];
    again.repetition = 2;
    made_up.cells[0].runs.push_back(again);
  }
  SECTION("and changes nothing when it is the same") {
    const Made made(made_up);
    CHECK(made.findings().cells[0].measures[0].all->count == 3);
    CHECK(made.findings().disagreements.empty());
    CHECK(made.findings().good());
  }
  SECTION("but reveals plugins that depend on more than the seed") {
    made_up.cells[0].runs[4].state_hash = "ffffffffffffffff";
    const Made made(made_up);
    REQUIRE(made.findings().disagreements.size() == 1);
    CHECK(made.findings().disagreements[0].runs == std::vector<std::size_t>{1, 4});
    CHECK_FALSE(made.findings().good());
  }
}

TEST_CASE("Outliers are listed with their runs, the farthest first") {
  const Made made(made_from({{10, 11, 12, 13, 14, 30, 11, 12, 100, 13}}));
  const Findings findings = made.findings();
  const auto& outliers = findings.cells[0].outliers;
  REQUIRE(outliers.size() == 2);
  CHECK(outliers[0].value == 100.0);
  CHECK(findings.results.runs[outliers[0].run].seed == 9);
  CHECK(outliers[1].value == 30.0);
}

TEST_CASE("Few values have no outliers, and equal ones none by rounding") {
  CHECK(Made(made_from({{1, 1, 1, 50}})).findings().cells[0].outliers.empty());
  CHECK(
      Made(made_from({{0.3, 0.1 + 0.2, 0.3, 0.3, 0.3, 0.3}})).findings().cells[0].outliers.empty());
  const Made made(made_from({{3, 3, 3, 3, 3, 4}}));
  const Findings findings = made.findings();
  REQUIRE(findings.cells[0].outliers.size() == 1);
  CHECK(std::isinf(findings.cells[0].outliers[0].beyond));
}

TEST_CASE("Measures are shown as the experiment names them, or else all") {
  MadeExperiment made_up = made_from({{1, 2}});
  for (auto& run : made_up.cells[0].runs) {
    run.measures["a_first"] = 1.0;
    run.measures["time_s"] = 2.0;
  }
  Questions questions;
  const auto names = [](const Findings& findings) {
    std::vector<std::string> all;
    for (const std::size_t i : findings.measures) all.push_back(findings.results.measures[i].name);
    return all;
  };
  CHECK(names(Made(made_up).findings()) ==
        std::vector<std::string>{"path_length_m", "time_s", "a_first"});
  questions.measures = {"time_s", "success", "unknown"};
  CHECK(names(Made(made_up, questions).findings()) == std::vector<std::string>{"time_s"});
}

TEST_CASE("A measure without a value is left out of its cell's numbers") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  made_up.cells[0].runs[0].measures["path_length_m"] = std::nullopt;
  made_up.cells[0].runs[1].measures["path_length_m"] = std::numeric_limits<double>::infinity();
  const Made made(made_up);
  CHECK(made.findings().cells[0].measures[0].all->count == 1);
}

TEST_CASE("Seeds have 64 bits") {
  MadeExperiment made_up = made_from({{1}});
  made_up.cells[0].runs[0].seed = std::numeric_limits<std::uint64_t>::max();
  CHECK(Made(made_up).findings().results.runs[0].seed == std::numeric_limits<std::uint64_t>::max());
}
