#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using elsie::experiment::Expectation;
using namespace elsie::test;

namespace {

// The only verdict of a study.
Verdict judged(const MadeExperiment& experiment, const Expectation& expectation) {
  return Made(experiment, expecting(expectation)).findings().verdicts.at(0);
}

Expectation success_at_least(double rate) {
  Expectation expectation = expectation_of("it succeeds", "success", Statistic::rate);
  expectation.at_least = rate;
  return expectation;
}

Expectation mean_path() { return expectation_of("it is short", "path_length_m"); }

// 20 runs, the last of them without success.
MadeExperiment nineteen_of_twenty() {
  MadeExperiment made_up = made_from({std::vector<double>(20, 5.0)});
  made_up.cells[0].label = "fusion";
  made_up.cells[0].runs[19].outcome = "time_limit";
  return made_up;
}

}  // namespace

TEST_CASE("A rate of success is given with its counts") {
  const Verdict verdict = judged(nineteen_of_twenty(), success_at_least(1.0));
  CHECK_FALSE(verdict.met());
  REQUIRE(verdict.claims.size() == 1);
  CHECK(verdict.claims[0].value == 0.95);
  CHECK(verdict.claims[0].sentence ==
        "success rate of fusion is 0.95 (19 of 20), expected at least 1");
  CHECK(judged(nineteen_of_twenty(), success_at_least(0.95)).met());
}

TEST_CASE("A run that crashed counts as not successful, and is mentioned") {
  MadeExperiment made_up = nineteen_of_twenty();
  made_up.cells[0].runs[0].end_as("crash");
  const Verdict verdict = judged(made_up, success_at_least(0.95));
  CHECK_FALSE(verdict.met());
  CHECK(verdict.claims[0].sentence ==
        "success rate of fusion is 0.9 (18 of 20; 1 run ended abnormally), expected at least "
        "0.95");
}

TEST_CASE("A run that crashed has no other value: nothing is met by crashes") {
  MadeExperiment made_up = made_from({{5, 5, 5, 5}, {5, 5}});
  auto& runs = made_up.cells[0].runs;
  for (auto& cell : made_up.cells) {
    for (auto& run : cell.runs) run.measures["collisions"] = run.measures["time_s"] = 0.0;
  }
  Expectation expectation = mean_path();
  expectation.where = {{"scheme", {"a"}}};
  expectation.measure = "collisions";
  expectation.statistic = Statistic::rate;
  expectation.at_most = 0.0;
  CHECK(judged(made_up, expectation).met());
  SECTION("some of them crashed: the value of the others, and their number") {
    runs[1].end_as("crash");
    runs[2].measures["collisions"] = 2.0;
    const Verdict verdict = judged(made_up, expectation);
    CHECK_FALSE(verdict.met());
    CHECK(verdict.claims[0].sentence ==
          "rate of collisions of a is 0.33333 (1 of 3; 1 run ended abnormally), expected at "
          "most 0");
  }
  SECTION("all but one crashed") {
    for (std::size_t i = 1; i < 4; ++i) runs[i].end_as("crash");
    CHECK(judged(made_up, expectation).claims[0].found ==
          "rate of collisions of a is 0 (0 of 1; 3 runs ended abnormally)");
  }
  SECTION("all of them crashed") {
    for (auto& run : runs) run.end_as("crash");
    const Verdict verdict = judged(made_up, expectation);
    CHECK_FALSE(verdict.met());
    REQUIRE(verdict.claims.size() == 1);
    CHECK(verdict.claims[0].sentence ==
          "rate of collisions of a is not known: no run that ended normally of a has a value; "
          "expected at most 0");
    expectation.measure = "success";
    expectation.per = "time_s";
    CHECK_THAT(judged(made_up, expectation).claims.at(0).found,
               Catch::Contains("success per time_s of a is not known"));
    expectation.per.clear();
    CHECK(judged(made_up, expectation).claims[0].value == 0.0);  // none succeeded, which is known
  }
  SECTION("the mean of success is its rate") {
    runs[0].end_as("crash");
    expectation.measure = "success";
    for (const Statistic statistic : {Statistic::rate, Statistic::mean}) {
      expectation.statistic = statistic;
      CHECK(judged(made_up, expectation).claims[0].value == 0.75);
    }
  }
}

TEST_CASE("A ratio to 0 is not known, and so not met") {
  const MadeExperiment made_up = made_from({{0, 0, 0}, {30, 33, 36}});
  Expectation expectation = mean_path();
  expectation.relation = Relation::ratio;
  expectation.reference = {{"scheme", "a"}};
  expectation.at_least = 2.0;
  const Verdict verdict = judged(made_up, expectation);
  CHECK_FALSE(verdict.met());
  REQUIRE(verdict.claims.size() == 1);
  CHECK(verdict.claims[0].sentence ==
        "mean path_length_m of b is not known: that of a is 0; expected at least 2 times that of "
        "the cell with scheme a");
  expectation.confidence = 0.95;
  CHECK_FALSE(judged(made_up, expectation).met());
  SECTION("nor is an interval that reaches there") {
    const Claim claim = judged(made_from({{0, 0, 3}, {30, 33, 36}}), expectation).claims[0];
    CHECK_FALSE(claim.holds);
    CHECK_FALSE(claim.interval);
    CHECK_THAT(claim.found, Catch::Contains("; no interval, as that of a may be 0)"));
  }
  SECTION("a difference is") {
    expectation.relation = Relation::difference;
    CHECK(judged(made_up, expectation).met());
  }
}

TEST_CASE("With confidence the whole interval must keep to what is expected") {
  Expectation expectation = success_at_least(0.8);
  CHECK(judged(nineteen_of_twenty(), expectation).met());
  expectation.confidence = 0.95;  // Wilson: 19 of 20 is from 0.764
  const Verdict verdict = judged(nineteen_of_twenty(), expectation);
  CHECK_FALSE(verdict.met());
  CHECK(verdict.claims[0].interval->low == Approx(0.7639).margin(1e-4));
  CHECK(verdict.claims[0].sentence ==
        "success rate of fusion is 0.95 (19 of 20; 95 % interval from 0.76387 to 0.99112), "
        "expected at least 0.8, with 95 % confidence");
  expectation.at_least = 0.76;
  CHECK(judged(nineteen_of_twenty(), expectation).met());
}

TEST_CASE("Limits, from below, from above, around") {
  const MadeExperiment made_up = made_from({{1, 2, 3}});
  Expectation expectation = mean_path();
  const auto met = [&] { return judged(made_up, expectation).met(); };
  SECTION("at most") {
    expectation.at_most = 2.0;
    CHECK(met());
    expectation.at_most = 1.9;
    CHECK_FALSE(met());
    expectation.tolerance = 0.1;
    CHECK(met());
  }
  SECTION("at least and at most") {
    expectation.at_least = 1.5;
    expectation.at_most = 2.5;
    CHECK(met());
    expectation.at_least = 2.1;
    CHECK_FALSE(met());
  }
  SECTION("about") {
    expectation.about = 2.2;
    expectation.tolerance = 0.1;
    CHECK_FALSE(met());
    CHECK(judged(made_up, expectation).claims[0].sentence ==
          "mean path_length_m of a is 2 m (3 runs), expected about 2.2 m give or take 0.1 m");
    expectation.tolerance = 0.25;
    CHECK(met());
  }
}

TEST_CASE("A value near a limit is not rounded to the limit") {
  Expectation expectation = mean_path();
  expectation.at_least = 2.0;
  const Verdict verdict = judged(made_from({{1.999999999, 1.999999999}}), expectation);
  CHECK_FALSE(verdict.met());
  CHECK(verdict.claims[0].sentence ==
        "mean path_length_m of a is 1.999999999 m (2 runs), expected at least 2 m");
}

TEST_CASE("An expectation is about the cells that it names") {
  const MadeExperiment made_up = made_from({{1, 1}, {5, 5}, {9, 9}});
  Expectation expectation = mean_path();
  expectation.at_most = 6.0;
  CHECK(judged(made_up, expectation).claims.size() == 3);
  CHECK_FALSE(judged(made_up, expectation).met());
  expectation.where = {{"scheme", {"a", "b"}}};
  CHECK(judged(made_up, expectation).claims.size() == 2);
  CHECK(judged(made_up, expectation).met());
  expectation.where = {{"scheme", {"*"}}, {"world", {"w*"}}};
  CHECK(judged(made_up, expectation).claims.size() == 3);
  expectation.where = {{"scheme", {"d"}}};
  CHECK_FALSE(judged(made_up, expectation).met());
  CHECK(judged(made_up, expectation).trouble == "it covers no cell");
}

TEST_CASE("Other statistics, and successful runs only") {
  MadeExperiment made_up = made_from({{1, 2, 3, 100}});
  made_up.cells[0].runs[3].outcome = "failure";
  Expectation expectation = mean_path();
  expectation.at_most = 3.0;
  for (const Statistic statistic : {Statistic::mean, Statistic::maximum}) {
    expectation.statistic = statistic;
    expectation.runs = elsie::experiment::Runs::all;
    CHECK_FALSE(judged(made_up, expectation).met());
    expectation.runs = elsie::experiment::Runs::successes;
    CHECK(judged(made_up, expectation).met());
  }
  expectation.runs = elsie::experiment::Runs::all;
  expectation.statistic = Statistic::median;
  CHECK(judged(made_up, expectation).met());
  expectation.statistic = Statistic::minimum;
  CHECK(judged(made_up, expectation).claims[0].value == 1.0);
}

TEST_CASE("One measure per another") {
  MadeExperiment made_up = made_from({{10, 20, 30}});
  for (auto& run : made_up.cells[0].runs) run.measures["time_s"] = 10.0;
  made_up.cells[0].runs[2].measures["time_s"] = 0.0;  // no speed: left out
  Expectation expectation = mean_path();
  expectation.per = "time_s";
  expectation.at_least = 1.5;
  const Verdict verdict = judged(made_up, expectation);
  CHECK(verdict.met());
  CHECK(verdict.claims[0].sentence ==
        "mean path_length_m per time_s of a is 1.5 (2 runs), expected at least 1.5");
}

TEST_CASE("Cells relative to each other") {
  const MadeExperiment made_up = made_from({{60, 64, 68}, {30, 33, 36}});
  Expectation expectation = mean_path();
  expectation.relation = Relation::ratio;
  expectation.reference = {{"scheme", "a"}};
  expectation.at_most = 0.6;
  const Verdict verdict = judged(made_up, expectation);
  CHECK(verdict.met());
  REQUIRE(verdict.claims.size() == 1);  // the reference is not compared with itself
  CHECK(verdict.claims[0].cell == 1);
  CHECK(verdict.claims[0].sentence ==
        "mean path_length_m of b is 0.51562 times that of a (33 m, 3 runs, against 64 m, 3 runs), "
        "expected at most 0.6 times that of the cell with scheme a");
  SECTION("with confidence: pairs of a seed are drawn together") {
    expectation.confidence = 0.95;
    const Claim claim = judged(made_up, expectation).claims[0];
    CHECK(claim.holds);
    // Residuals -0.9375, 0, 0.9375: a standard error of 0.9375 / sqrt(3) / 64; t(0.975; 2)
    // = 4.3027.
    CHECK(claim.interval->low == Approx(0.515625 - 0.036389).margin(1e-5));
    CHECK(claim.interval->high == Approx(0.515625 + 0.036389).margin(1e-5));
  }
  SECTION("over the seeds for which both have a value") {
    // b fails the hard seeds: a's times for these must not count.
    MadeExperiment hard = made_from({{10, 20, 30, 40}, {10, 20, 30, 40}});
    hard.cells[1].runs[2].outcome = "failure";
    hard.cells[1].runs[3].outcome = "failure";
    expectation.runs = elsie::experiment::Runs::successes;
    const Claim claim = judged(hard, expectation).claims[0];
    CHECK(claim.value == 1.0);
    CHECK_FALSE(claim.holds);
    CHECK(claim.sentence ==
          "mean path_length_m of successful runs of b is 1 times that of a (15 m, 2 runs, against "
          "15 m, 2 runs; of the seeds with which both succeeded), expected at most 0.6 times that "
          "of the cell with scheme a");
    for (auto& run : hard.cells[0].runs) run.outcome = run.seed > 2 ? "success" : "failure";
    CHECK_THAT(judged(hard, expectation).claims[0].sentence,
               Catch::Contains("there is no seed with which b and a both succeeded"));
  }
  SECTION("two rates of 1 are not certainly equal") {
    Expectation rates = success_at_least(-0.1);
    rates.relation = Relation::difference;
    rates.reference = {{"scheme", "a"}};
    CHECK(judged(made_up, rates).met());
    rates.confidence = 0.95;
    CHECK_FALSE(judged(made_up, rates).met());  // of three runs each
  }
  SECTION("as a difference") {
    expectation.relation = Relation::difference;
    expectation.at_most = -30.0;
    CHECK(judged(made_up, expectation).met());
    CHECK(judged(made_up, expectation).claims[0].value == -31.0);
  }
  SECTION("while the other cell is not done") {
    MadeExperiment incomplete = made_up;
    incomplete.cells[0].runs[0].end_as("pending");
    const Claim claim = judged(incomplete, expectation).claims[0];
    CHECK_FALSE(claim.holds);
    CHECK(claim.sentence ==
          "mean path_length_m of b is not known yet: not all runs of a are done, 1 is still to be "
          "done; "
          "expected at most 0.6 times that of the cell with scheme a");
  }
}

TEST_CASE("What cannot be judged is not met") {
  MadeExperiment made_up = made_from({{1, 2, 3}});
  SECTION("not all runs are done") {
    made_up.cells[0].runs[1].end_as("pending");
    made_up.cells[0].runs[2].end_as("pending");
    const Verdict verdict = judged(made_up, success_at_least(0.0));
    CHECK_FALSE(verdict.met());
    CHECK(verdict.open());
    CHECK(verdict.claims[0].sentence ==
          "success rate of a is not known yet: not all runs of a are done, 2 are still to be done; "
          "expected at least 0");
  }
  SECTION("there is no such measure") {
    Expectation expectation = mean_path();
    expectation.measure = "path_lenght_m";
    expectation.at_least = 0.0;
    CHECK_FALSE(judged(made_up, expectation).met());
    CHECK_FALSE(judged(made_up, expectation).open());
    CHECK(judged(made_up, expectation).trouble ==
          "no run has a measure 'path_lenght_m'; did you mean 'path_length_m'?");
  }
  SECTION("no run has a value") {
    for (auto& run : made_up.cells[0].runs) run.outcome = "failure";
    Expectation expectation = mean_path();
    expectation.runs = elsie::experiment::Runs::successes;
    expectation.at_least = 0.0;
    const Verdict verdict = judged(made_up, expectation);
    CHECK_FALSE(verdict.met());
    CHECK(verdict.claims[0].sentence ==
          "mean path_length_m of successful runs of a is not known: no successful run of a has a "
          "value; expected at least 0 m");
  }
  SECTION("too few for an interval") {
    Expectation expectation = mean_path();
    expectation.at_least = 0.0;
    expectation.confidence = 0.9;
    CHECK_FALSE(judged(made_from({{1}}), expectation).met());
  }
  SECTION("a part of the runs is in another database") {
    made_up.shard = "1/2";
    made_up.all_runs = 6;
    CHECK_FALSE(judged(made_up, success_at_least(0.0)).met());
    CHECK(judged(made_up, success_at_least(0.0)).open());
    CHECK(judged(made_up, success_at_least(0.0)).trouble ==
          "3 of 6 runs are not in this database, which is shard 1/2; an expectation needs all of "
          "them");
  }
}

TEST_CASE("Missing runs leave an expectation open, unless another cell misses it") {
  MadeExperiment made_up = made_from({{1, 2, 3}, {4, 5, 6}});
  made_up.cells[1].runs[2].end_as("pending");
  Questions questions = expecting(mean_path());
  Expectation& short_path = questions.expectations[0];
  short_path.name = "short";
  const auto findings = [&](double at_most) {
    short_path.at_most = at_most;
    return Made(made_up, questions).findings();
  };
  SECTION("open: neither passed nor failed, in every form") {
    const Findings open = findings(2.0);
    CHECK(open.open());
    CHECK_FALSE(open.good());
    CHECK_THAT(terminal_report(open, "r.db"),
               Contains("  not known yet  short: ") &&
                   Contains("path_length_m of b is not known yet: ") && !Contains("NOT MET"));
    const auto json = nlohmann::json::parse(json_report(open))["expectations"][0];
    CHECK(json["met"].is_null());
    CHECK(json["cells"][0]["met"] == true);
    CHECK(json["cells"][1]["met"].is_null());
    CHECK_THAT(junit_report(open, "r.db"),
               Contains("failures=\"1\" errors=\"0\" skipped=\"1\"") &&
                   Contains("<skipped message=\"not known yet: mean path_length_m of b"));
    CHECK_THAT(Made(made_up, questions).html(),
               Contains("<h2 class=\"verdict open\">") &&
                   Contains("<span>1 of 1 expectation is not known yet</span>"));
  }
  SECTION("missed: what is missing cannot save it") {
    const Findings missed = findings(1.0);
    CHECK_FALSE(missed.open());
    CHECK_THAT(terminal_report(missed, "r.db"), Contains("  NOT MET  short"));
    CHECK(nlohmann::json::parse(json_report(missed))["expectations"][0]["met"] == false);
    CHECK_THAT(junit_report(missed, "r.db"),
               Contains("<failure message=\"mean path_length_m of a is 2 m (3 runs), expected at "
                        "most 1 m\""));
  }
}

TEST_CASE("Equal runs are reported: they are one observation") {
  MadeExperiment made_up = made_from({{5, 5, 5}});
  for (auto& run : made_up.cells[0].runs) run.state_hash = "00000000000000aa";
  CHECK(judged(made_up, success_at_least(0.5)).claims[0].sentence ==
        "success rate of a is 1 (3 of 3, all the same run), expected at least 0.5");
}

TEST_CASE("An expectation without a name is not stated twice") {
  Expectation expectation = success_at_least(0.5);
  CHECK(judged(nineteen_of_twenty(), expectation).expected == "success rate: at least 0.5");
  expectation.name = "rate of success, scheme=a: at least 0.5";
  CHECK(judged(nineteen_of_twenty(), expectation).expected.empty());
  expectation.confidence = 0.9;
  CHECK(judged(nineteen_of_twenty(), expectation).expected == "with 90 % confidence");
}
