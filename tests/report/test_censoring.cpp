// Runs that the time limit stopped or that failed, measures without values in some runs, worlds
// without goals.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using elsie::experiment::Expectation;
using namespace elsie::test;

namespace {

// A cell of ten runs; the time limit of 40 s stopped the last ones.
MadeExperiment with_stopped(std::size_t stopped) {
  MadeExperiment made_up = made_from({std::vector<double>(10, 5.0)});
  auto& runs = made_up.cells[0].runs;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool late = i + stopped >= runs.size();
    runs[i].measures["time_s"] = late ? 40.0 : 21.0 + static_cast<double>(i);
    runs[i].outcome = late ? "time_limit" : "success";
    runs[i].measures["success"] = late ? 0.0 : 1.0;
  }
  return made_up;
}

Expectation about_time() { return expectation_of("in time", "time_s"); }

Claim claimed(const MadeExperiment& made_up, const Expectation& expectation) {
  return Made(made_up, expecting(expectation)).findings().verdicts.at(0).claims.at(0);
}

MadeExperiment without_goals() {
  MadeExperiment made_up = made_from({{1, 2, 3, 4, 5, 6}, {2, 3, 4, 5, 6, 7}});
  for (auto& cell : made_up.cells) {
    cell.world_text = made_world(1, false);
    for (auto& run : cell.runs) {
      run.outcome = "time_limit";
      run.message = "the limit of simulated time was met";
      run.measures["success"] = 0.0;
      run.measures["time_s"] = 40.0;
    }
  }
  return made_up;
}

}  // namespace

TEST_CASE("A time that the limit cut off is given as a bound, not as a mean") {
  const auto time_of = [](const Findings& findings) { return findings.cells[0].measures[1]; };
  SECTION("all of them") {
    const Findings findings = Made(with_stopped(10)).findings();
    const MeasureFindings time = time_of(findings);
    CHECK_FALSE(time.all);
    CHECK_FALSE(time.interval);
    REQUIRE(time.censoring);
    CHECK(time.censoring->count == 10);
    CHECK_FALSE(time.censoring->median);
    const std::string text = terminal_report(findings, "r.db");
    CHECK_THAT(text, Contains("> 40") && !Contains("40.00 +- 0.00") && !Contains("40 +- 0"));
    CHECK_THAT(text, Contains("the time limit stopped runs"));
  }
  SECTION("some: the median is known") {
    const Findings findings = Made(with_stopped(3)).findings();
    const MeasureFindings time = time_of(findings);
    CHECK(time.censoring->median == 25.5);  // of 21 to 27 and three longer ones
    // By hand, Greenwood for log(-log) of the curve: after the first of ten, 0.473 to 0.985 remain.
    CHECK(time.censoring->median_interval->low == 21.0);
    CHECK(std::isinf(time.censoring->median_interval->high));
    CHECK_THAT(Made(with_stopped(3)).html(), Contains(">21 or more<"));  // the table of medians
    CHECK_THAT(terminal_report(findings, "r.db"), Contains("median 25.5, 3 of 10 > 40.0"));
    const auto json = nlohmann::json::parse(json_report(findings));
    const auto& time_s = json["cells"][0]["measures"]["time_s"];
    CHECK(time_s["mean"].is_null());
    CHECK(time_s["censored"] == 3);
    CHECK(time_s["limit"] == 40.0);
    CHECK(time_s["median"] == 25.5);
    CHECK(time_s["successes"]["mean"] == 24.0);
    CHECK(json["cells"][0]["measures"]["path_length_m"]["censored"] == 0);
  }
  SECTION("half of them: the median is not known either") {
    const Findings findings = Made(with_stopped(5)).findings();
    CHECK_FALSE(time_of(findings).censoring->median);
    CHECK_THAT(terminal_report(findings, "r.db"), Contains(" 5 of 10 > 40.0"));
  }
  SECTION("none") {
    const Findings findings = Made(with_stopped(0)).findings();
    CHECK_FALSE(time_of(findings).censoring);
    CHECK(time_of(findings).all->mean == 25.5);
  }
  SECTION("the page shows it, too") {
    const std::string html = Made(with_stopped(3)).html();
    CHECK_THAT(html, Contains("<b>median 25.5, 3 of 10 &gt; 40.0</b>"));
    CHECK_THAT(html, Contains("&gt;\xc2\xa0"
                              "40.0</td>"));
  }
}

TEST_CASE("An expectation about times that the limit cut off knows their lower bound") {
  Expectation expectation = about_time();
  SECTION("of the mean") {
    expectation.at_most = 35.0;  // the mean of the bounds is 28.8, but this is only a bound
    const Claim claim = claimed(with_stopped(3), expectation);
    CHECK_FALSE(claim.holds);
    CHECK_FALSE(claim.value);
    CHECK(claim.sentence ==
          "mean time_s of a is at least 28.8 s (10 runs; 3 runs were stopped by the time limit), "
          "expected at most 35 s");
    expectation.at_most.reset();
    expectation.at_least = 28.0;
    CHECK(claimed(with_stopped(3), expectation).holds);
    expectation.about = 28.8;
    CHECK_FALSE(claimed(with_stopped(3), expectation).holds);
  }
  SECTION("of the median, which is known below the limit") {
    expectation.statistic = Statistic::median;
    expectation.at_most = 26.0;
    CHECK(claimed(with_stopped(3), expectation).holds);
    CHECK(claimed(with_stopped(3), expectation).value == 25.5);
    CHECK_FALSE(claimed(with_stopped(6), expectation).holds);
    expectation.confidence = 0.95;  // up to the ninth of ten, which was stopped
    CHECK_FALSE(claimed(with_stopped(3), expectation).holds);
  }
  SECTION("of the standard deviation: not known") {
    expectation.statistic = Statistic::standard_deviation;
    expectation.at_most = 100.0;
    CHECK(claimed(with_stopped(3), expectation).sentence ==
          "standard deviation of time_s of a is not known: 3 runs were stopped by the time limit; "
          "expected at most 100 s");
  }
  SECTION("of the successful runs: they have times") {
    expectation.runs = elsie::experiment::Runs::successes;
    expectation.at_most = 24.0;
    CHECK(claimed(with_stopped(3), expectation).holds);
  }
  SECTION("relative to another cell: not known") {
    MadeExperiment made_up = with_stopped(3);
    made_up.cells.push_back(with_stopped(0).cells[0]);
    made_up.cells[1].label = made_up.cells[1].levels[1] = "b";
    expectation.relation = Relation::difference;
    expectation.reference = {{"scheme", "a"}};
    expectation.at_most = 10.0;
    CHECK_THAT(claimed(made_up, expectation).sentence,
               Contains("is not known: of a 3 runs were stopped by the time limit"));
  }
}

TEST_CASE("A run that failed early is not a fast one") {
  MadeExperiment made_up = with_stopped(1);
  for (std::size_t i : {0, 1}) {
    made_up.cells[0].runs[i].outcome = "failure";
    made_up.cells[0].runs[i].measures["time_s"] = 1.0;
  }
  made_up.cells.push_back(with_stopped(0).cells[0]);
  made_up.cells[1].label = made_up.cells[1].levels[1] = "b";
  const Made made(made_up);
  const Findings findings = made.findings();
  SECTION("in a table") {
    const MeasureFindings& time = findings.cells[0].measures[1];
    CHECK_FALSE(time.all);
    CHECK(time.censoring->count == 3);
    CHECK(time.censoring->failures == 2);
    CHECK(time.censoring->limit == 40.0);
    CHECK(time.censoring->least == 23.0);
    CHECK(time.censoring->median == 27.5);  // of 23 to 29 and three that are longer
    const std::string text = terminal_report(findings, "r.db");
    CHECK_THAT(text, Contains("median 27.5, 1 of 10 > 40.0, 2 failed"));
    CHECK_THAT(text, Contains("failed: runs that failed never reach their goals"));
    const auto json = nlohmann::json::parse(json_report(findings));
    CHECK(json["cells"][0]["measures"]["time_s"]["failed"] == 2);
    CHECK_THAT(made.html(), Contains("never</td>"));
  }
  SECTION("in views by factor and comparisons") {
    const Response time = responses(findings)[2];
    REQUIRE(time.name == "time_s");
    const Margin margin = margin_of(findings, time, {0});
    CHECK(margin.cut_off == 3);
    CHECK(margin.centre == 27.5);
    const auto all = compare(findings, "a", "b");
    CHECK(all[2].of_first.cut_off == 3);
    CHECK(all[2].effect.value > 0.0);
    CHECK(all[2].paired.above == 3);
    CHECK(all[2].paired.below == 0);
  }
  SECTION("in an expectation") {
    Expectation expectation = about_time();
    expectation.at_most = 30.0;
    CHECK_THAT(claimed(made_up, expectation).sentence,
               Contains("1 run was stopped by the time limit and 2 runs failed"));
    CHECK_FALSE(claimed(made_up, expectation).holds);
  }
}

TEST_CASE("The number of runs of a mean is given if it is not all of the cell's") {
  MadeExperiment made_up = made_from({{1, 2, 3, 4}, {1, 2, 3, 4}});
  for (auto& run : made_up.cells[0].runs) run.measures["first_s"] = 2.0 * double(run.seed);
  for (auto& run : made_up.cells[1].runs) run.measures["first_s"] = 1.0;
  made_up.cells[0].runs[1].measures["first_s"] = std::nullopt;
  made_up.cells[0].runs[2].measures["first_s"] = std::nullopt;
  const Made made(made_up);
  const std::string text = terminal_report(made.findings(), "r.db");
  CHECK_THAT(text, Contains("5.0 +- 4.2 (n 2)\n"));
  CHECK_THAT(text, !Contains("(n 4)"));
  CHECK_THAT(text, Contains("(n 2): over 2 runs, as the others"));
  CHECK_THAT(made.html(), Contains("<small>n 2</small>") && !Contains("<small>n 4</small>"));
  CHECK_THAT(terminal_report(Made(made_from({{1, 2}})).findings(), "r.db"), !Contains("(n "));
}

TEST_CASE("A world without goals has no rate of success") {
  const Made made(without_goals());
  const Findings findings = made.findings();
  CHECK_FALSE(findings.cells[0].goals);
  const std::string text = terminal_report(findings, "r.db");
  CHECK_THAT(text, Contains("no goals") && !Contains("0/6"));
  CHECK_THAT(text, Contains("40 +- 0") && !Contains(">"));  // the run was to take this long
  CHECK_THAT(csv_report(findings), Contains(",no_goals,") && !Contains("time_limit"));
  const auto json = nlohmann::json::parse(json_report(findings));
  CHECK(json["cells"][0]["goals"] == false);
  CHECK(json["cells"][0]["successes"].is_null());
  CHECK(json["cells"][0]["success_interval"].is_null());
  CHECK_THAT(junit_report(findings, "r.db"),
             Contains("name=\"successful runs\" value=\"no goals\""));
  const std::string html = made.html();
  CHECK_THAT(html, Contains("no goals") && !Contains("without success</li>") &&
                       !Contains("<i> of 12</i>"));
  CHECK_THAT(html, Contains("No run stands out."));

  Expectation expectation = about_time();
  expectation.measure = "success";
  expectation.statistic = Statistic::rate;
  expectation.at_most = 0.0;
  CHECK(claimed(without_goals(), expectation).sentence ==
        "success rate of a is not known: its world has no goals, so a run can neither succeed nor "
        "fail; expected at most 0");
}

TEST_CASE("Cells with and without goals in one table") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {2, 3, 4}});
  made_up.cells[1].world_text = made_world(1, false);
  for (auto& run : made_up.cells[1].runs) run.outcome = "time_limit";
  const Made made(made_up);
  CHECK_THAT(terminal_report(made.findings(), "r.db"), Contains("3/3") && Contains("no goals"));
  CHECK_THAT(made.html(), Contains("<dd>3<i> of 3</i></dd>"));
}

TEST_CASE("A difference below 0 is given as less") {
  const MadeExperiment made_up = made_from({{4, 5, 6}, {3.5, 4.5, 5.5}});
  Expectation expectation = expectation_of("shorter", "path_length_m");
  expectation.relation = Relation::difference;
  expectation.reference = {{"scheme", "a"}};
  expectation.at_most = -0.2;
  CHECK(
      claimed(made_up, expectation).sentence ==
      "mean path_length_m of b is 0.5 m less than that of a (4.5 m, 3 runs, against 5 m, 3 runs), "
      "expected at least 0.2 m less than in the cell with scheme a");
  expectation.at_least = -0.8;
  expectation.at_most = 0.1;
  expectation.tolerance = 0.05;
  CHECK_THAT(
      claimed(made_up, expectation).sentence,
      Contains("expected at most 0.8 m less and at most 0.1 m more than in the cell with scheme "
               "a give or take 0.05 m"));
  expectation.reference = {{"scheme", "b"}};
  CHECK_THAT(claimed(made_up, expectation).sentence, Contains("of a is 0.5 m more than that of b"));
}

TEST_CASE("A typical run has the commonest outcome, is in the middle, and is no outlier") {
  // Nine runs are stopped; the only success is far from them.
  MadeExperiment made_up = made_from({{10, 11, 12, 13, 14, 15, 16, 17, 18, 90}});
  for (auto& run : made_up.cells[0].runs) {
    run.outcome = run.seed == 10 ? "success" : "time_limit";
    run.robots[0].episodes = {{0, 1, "avoid"}};
    run.robots.push_back(run.robots[0]);
    run.robots[1].id = "r2";
  }
  CHECK_THAT(Made(made_up).html(), Contains("run 5, seed 5, a typical one"));
  SECTION("the middle one stands out in another measure: its neighbour is typical") {
    for (auto& run : made_up.cells[0].runs) {
      run.measures["collisions"] = run.seed == 5 ? 50.0 : 1.0;
    }
    CHECK_THAT(Made(made_up).html(), Contains("run 4, seed 4, a typical one"));
  }
}
