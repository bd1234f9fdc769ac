// Which runs views by factor and comparisons count.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "by_factor.h"
#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

Contrast contrast_of(const Findings& findings, const std::string& measure, const std::string& first,
                     const std::string& second) {
  for (const Contrast& one : compare(findings, first, second)) {
    if (one.response.name == measure) return one;
  }
  FAIL("there is no contrast of " + measure);
  return {};
}

// A batch that was stopped: all cells have seed 1; seed 2, whose paths are 100 m longer, is still
// to be done with the speeds 0.1, and 0.2 with fusion.
MadeExperiment stopped_batch() {
  MadeExperiment study = by_factor(2);
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    auto& run = study.cells[i].runs[1];
    *run.measures["path_length_m"] += 100.0;
    if (i == 2 || i == 3 || i == 5) {
      run.end_as("pending");
    }
  }
  return study;
}

// All seeds of these cells give the run of the first one.
MadeExperiment without_chance(std::size_t cells) {
  MadeExperiment study = by_factor(12);
  for (std::size_t i = 0; i < cells; ++i) {
    MadeCell& cell = study.cells[i];
    for (auto& run : cell.runs) {
      const auto seed = run.seed;
      run = cell.runs[0];
      run.seed = seed;
      run.state_hash = "one and the same";
    }
  }
  return study;
}

nlohmann::json json_of(const Findings& findings, const Asked& asked) {
  return nlohmann::json::parse(json_report(findings, answer(findings, asked)));
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

TEST_CASE("Views by factor count only seeds that have a value in every cell") {
  const Made made(stopped_batch());
  const Findings findings = made.findings();
  const Asked asked{{"speed"}, {}, {}};
  const Answers answers = answer(findings, asked);
  REQUIRE(answers.levels.size() == 3);
  const auto path = [&](std::size_t level) { return answers.levels[level].margins[1]; };
  CHECK(path(0).centre == Approx(9.1));  // of seed 1: the slower, the longer
  CHECK(path(1).centre == Approx(7.1));
  CHECK(path(2).centre == Approx(3.1));
  CHECK(path(2).seeds == 1);
  CHECK(path(2).dropped_seeds == 1);
  CHECK_THAT(
      terminal_answers(findings, answers),
      Contains("note: 1 seed is left out, without a value in some of the cells; 1 seed left"));
  const auto json = json_of(findings, asked);
  CHECK(json["by"][0]["measures"]["path_length_m"]["dropped_seeds"] == 1);
  CHECK(json["by_notes"].size() == 1);
  CHECK_THAT(made.html(), Contains("1 seed is left out, without a value in some of the cells"));
}

TEST_CASE("A comparison and a model need two seeds that have a value in every cell") {
  const Made made(stopped_batch());
  const Findings findings = made.findings();
  CHECK_THROWS_WITH(compare(findings, "speed=0.4", "speed=0.1"),
                    Contains("fewer than two seeds have a value of"));
  CHECK(compare(findings, "0.4, fusion", "0.4, arbitration").size() == 4);
  CHECK_THROWS_WITH(factor_model(findings, "path_length_m ~ speed"),
                    Contains("runs of 1 seed only with a value in each cell"));
}

TEST_CASE("Without a seed that has a value in every cell there are no numbers, and a note") {
  MadeExperiment study = stopped_batch();
  study.cells[0].runs[0].end_as("pending");
  const Made made(study);
  const Answers answers = answer(made.findings(), {{"speed"}, {}, {}});
  CHECK_FALSE(answers.levels[0].margins[1].centre);
  CHECK(answers.levels[0].margins[1].dropped_seeds == 2);
  CHECK_THAT(made.html(), Contains("no seed has a value in each of the cells"));
}

TEST_CASE("Seeds that give one and the same run are one observation") {
  const Asked asked{{"speed"}, {{"coordinator=fusion", "coordinator=arbitration"}}, {}};
  SECTION("in every cell: no intervals, no tests, no model") {
    const Made made(without_chance(6));
    const Findings findings = made.findings();
    const Contrast path =
        contrast_of(findings, "path_length_m", "coordinator=fusion", "coordinator=arbitration");
    CHECK(path.certain);
    CHECK(path.difference == Approx(2.0));
    CHECK_FALSE(path.interval);
    CHECK_FALSE(path.effect.interval);
    CHECK(path.pooled_p == 1.0);
    CHECK(path.paired.p == 1.0);
    const std::string text = terminal_answers(findings, answer(findings, asked));
    CHECK_THAT(text, Contains("nothing is random") && !Contains("< 0.001"));
    const auto json = json_of(findings, asked);
    CHECK(json["cells"][0]["one_run"] == true);
    CHECK(json["comparisons"][0]["measures"][1]["seed_p"].is_null());
    CHECK(json["comparisons"][0]["measures"][1]["pooled_p_holm"].is_null());
    CHECK(json["by"][0]["measures"]["path_length_m"]["interval"].is_null());
    CHECK(json["by"][0]["measures"]["success"]["interval"].is_null());
    CHECK_THROWS_WITH(factor_model(findings, "path_length_m ~ speed"),
                      Contains("all seeds of each cell gave one and the same run"));
    CHECK_THAT(made.html(), Contains("nothing is random, so there are no intervals"));
  }
  SECTION("in one cell: it counts once, and has no part in the uncertainty") {
    const Made made(without_chance(1));
    const Findings findings = made.findings();
    const Contrast one = contrast_of(findings, "path_length_m", "0.4, fusion", "0.4, arbitration");
    CHECK_FALSE(one.certain);
    CHECK(one.pooled_p == Approx(2.0 / 13.0));  // the first of thirteen values
    CHECK_THAT(contrast_notes({one}, true)[0],
               Contains("all seeds of 1 cell gave one and the same run"));
    const FactorModel model = factor_model(findings, "path_length_m ~ speed + coordinator");
    CHECK(model.runs == 61);
    CHECK_THAT(model.warnings[0], Contains("all seeds of 1 cell gave one and the same run"));
    // Of the fast runs, those of arbitration all fail, those of fusion all succeed.
    const Margin fast = margin_of(findings, responses(findings)[0], {0, 1});
    CHECK(fast.centre == 0.5);
    CHECK(fast.interval->low == Approx(0.5 * wilson_interval(12, 12, 0.95).low));
    CHECK(fast.interval->high == Approx(0.5));
    CHECK(json_of(findings, asked)["cells"][1]["one_run"] == false);
  }
}

TEST_CASE("Where combinations of levels are missing, only cells that match count") {
  MadeExperiment study = by_factor();
  study.cells.erase(study.cells.begin());  // 0.4 with arbitration, whose paths are short
  const Made made(study);
  const Findings findings = made.findings();
  const Asked asked{{"coordinator"}, {{"coordinator=fusion", "coordinator=arbitration"}}, {}};
  const Answers answers = answer(findings, asked);
  const Margin &arbitration = answers.levels[1].margins[1], &fusion = answers.levels[0].margins[1];
  CHECK(answers.levels[1].levels[0] == "arbitration");
  CHECK(*fusion.centre - *arbitration.centre == Approx(2.0));
  CHECK(fusion.dropped_cells == 1);
  const Contrast& path = answers.comparisons[0][1];
  CHECK(path.difference == Approx(2.0));
  CHECK(path.of_first.runs == 12);
  const std::string note = "1 cell is left out, without a match in all other factors";
  CHECK_THAT(terminal_answers(findings, answers), Contains("note: " + note));
  CHECK_THAT(made.html(), Contains(note));
  CHECK(json_of(findings, asked)["by"][0]["measures"]["path_length_m"]["dropped_cells"] == 1);
  CHECK(json_of(findings, asked)["comparisons"][0]["measures"][1]["notes"][0] == note);
  SECTION("a model that leaves out a factor warns") {
    const FactorModel without = factor_model(findings, "path_length_m ~ coordinator");
    REQUIRE(without.warnings.size() == 1);
    CHECK_THAT(without.warnings[0], Contains("the model leaves out 'speed'"));
    CHECK(factor_model(findings, "path_length_m ~ coordinator + speed").warnings.empty());
  }
  SECTION("a model of a complete grid may leave out a factor") {
    CHECK(factor_model(Made(by_factor()).findings(), "path_length_m ~ speed").warnings.empty());
  }
}

TEST_CASE("Levels without any match are shown with the note that they differ in more") {
  MadeExperiment study = by_factor();
  std::erase_if(study.cells, [](const MadeCell& cell) {
    return (cell.levels[1] == "0.1") != (cell.levels[2] == "fusion");
  });
  const Answers answers = answer(Made(study).findings(), {{"coordinator"}, {}, {}});
  CHECK(answers.levels[0].margins[1].centre);
  REQUIRE(answers.by_notes.size() == 1);
  CHECK_THAT(answers.by_notes[0], Contains("no cells match in all other factors"));
}
