// Formulas in runs that never reached their goals.
#include <catch2/catch.hpp>

#include "elsie/report/formulas.h"

#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

// Ten runs of 6 m. Eight take 21 s to 28 s; the limit of 40 s stopped the ninth, the tenth failed
// after 2 s.
MadeExperiment study() {
  MadeExperiment made_up = made_from({std::vector<double>(10, 6.0)});
  for (auto& run : made_up.cells[0].runs) {
    run.measures["time_s"] = 20.0 + static_cast<double>(run.seed);
  }
  auto& runs = made_up.cells[0].runs;
  runs[8].outcome = "time_limit";
  runs[8].measures["time_s"] = 40.0;
  runs[9].outcome = "failure";
  runs[9].measures["time_s"] = 2.0;
  return made_up;
}

struct Seen {
  Findings findings;
  std::vector<std::string> sentences;

  const MeasureFindings& of(const std::string& name) const {
    for (std::size_t i = 0; i < findings.measures.size(); ++i) {
      if (findings.results.measures[findings.measures[i]].name == name) {
        return findings.cells[0].measures[i];
      }
    }
    throw std::out_of_range(name);
  }
};

Seen seen(const std::vector<std::pair<std::string, std::string>>& formulas,
          const Questions& questions = {}, const MadeExperiment& made_up = study()) {
  const Made made(made_up);
  Results results = ResultsFile(made.path).results();
  std::vector<elsie::experiment::MeasureUse> uses;
  for (const auto& [name, formula] : formulas) {
    uses.push_back({.name = name, .location = {}, .formula = formula, .unit = "", .meaning = ""});
  }
  auto sentences = add_formulas(results, uses);
  return {find(std::move(results), questions), std::move(sentences)};
}

}  // namespace

TEST_CASE("A formula that rises with the time is a bound where the time is one") {
  const Seen all =
      seen({{"minutes", "time_s / 60"}, {"hours", "minutes / 60 + 0 * path_length_m"}});
  for (const char* name : {"minutes", "hours"}) {
    CAPTURE(name);
    const MeasureFindings& found = all.of(name);
    CHECK_FALSE(found.all);
    REQUIRE(found.censoring);
    CHECK(found.censoring->count == 2);
    CHECK(found.censoring->failures == 1);
  }
  CHECK(all.of("minutes").censoring->limit == Approx(40.0 / 60.0));
  CHECK(all.of("minutes").censoring->median == Approx(25.5 / 60.0));
  CHECK(all.sentences.empty());
}

TEST_CASE("An expectation of a formula knows that its values are bounds") {
  elsie::experiment::Expectation fast;
  fast.name = "fast";
  fast.measure = "minutes";
  fast.at_most = 2.0;
  const Seen all = seen({{"minutes", "time_s / 60"}}, elsie::test::expecting(fast));
  CHECK_FALSE(all.findings.verdicts[0].met());
  CHECK_THAT(all.findings.verdicts[0].claims[0].sentence,
             Contains("1 run was stopped by the time limit and 1 run failed"));
}

TEST_CASE("A formula of the time that does not rise has no value where the time is a bound") {
  const Seen all = seen({{"hurry", "1 / time_s"}, {"off", "abs(time_s - 50)"}});
  for (const char* name : {"hurry", "off"}) {
    CAPTURE(name);
    CHECK_FALSE(all.of(name).censoring);
    CHECK(all.of(name).values.size() == 8);
  }
  REQUIRE(all.sentences.size() == 2);
  CHECK_THAT(all.sentences[0], Contains("'hurry' has no value in 2 runs without success") &&
                                   Contains("does not rise with time_s"));
  CHECK_THAT(all.findings.results.measures.back().meaning, Contains("no value in 2 runs"));
}

TEST_CASE("A rate by robots and minutes compares worlds of any size, whatever ended their runs") {
  MadeExperiment made_up = study();
  for (auto& run : made_up.cells[0].runs) {
    run.robots.clear();
    for (const char* id : {"r1", "r2", "r3"}) {
      run.robots.emplace_back().id = id;
      run.robots.back().end.emplace();
    }
  }
  const Seen all =
      seen({{"rate", "path_length_m / robots / minute"}, {"length", "minutes"}}, {}, made_up);
  CHECK(all.of("rate").all->count == 10);
  CHECK(all.of("rate").all->largest == Approx(6.0 / 3.0 / (2.0 / 60.0)));
  REQUIRE(all.of("length").censoring);  // as of time_s
  CHECK(all.of("length").censoring->limit == Approx(40.0 / 60.0));
  CHECK(all.sentences.empty());
}

TEST_CASE("A rate describes the time that a run took, and keeps its value") {
  const Seen all = seen({{"speed", "path_length_m / time_s"}, {"capped", "min(time_s, 2)"}});
  CHECK(all.of("speed").all->count == 10);
  CHECK(all.of("speed").all->largest == 3.0);
  CHECK(all.of("capped").all->count == 10);  // longer times would not change it
  CHECK(all.sentences.empty());
}
