// Runs of several cells that are the same bit by bit, because a factor has no effect on them.
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "by_factor.h"
#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

// A third of the runs has no success, in all cells alike.
MadeExperiment mixed() {
  MadeExperiment study = by_factor(12);
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    for (MadeRun& run : study.cells[i].runs) {
      const bool late = (run.seed + i) % 3 == 0 || (i < 2 && run.seed % 2 == 0);
      run.outcome = late ? "time_limit" : "success";
      if (late) run.measures["time_s"] = 100.0;
    }
  }
  return study;
}

// Each cell three times, with levels of a factor that has no effect on its runs.
MadeExperiment with_noise(const MadeExperiment& study) {
  MadeExperiment longer = study;
  longer.factors.emplace_back("noise");
  longer.cells.clear();
  for (std::size_t i = 0; i < study.cells.size(); ++i) {
    for (const std::string noise : {"0", "0.1", "0.3"}) {
      MadeCell& cell = longer.cells.emplace_back(study.cells[i]);
      cell.label += ", " + noise;
      cell.levels.push_back(noise);
      for (MadeRun& run : cell.runs) {
        run.state_hash = "cell " + std::to_string(i) + ", seed " + std::to_string(run.seed);
      }
    }
  }
  return longer;
}

const std::string kFusionCells = "coordinator=fusion",
                  kArbitrationCells = "coordinator=arbitration";

}  // namespace

TEST_CASE("Runs that a factor has no effect on are said to be copies, in every form") {
  const Made made(with_noise(by_factor()));
  const Findings findings = made.findings();
  const std::string words =
      "72 of 108 runs repeat another one, bit by bit: 'noise' had no effect on any run; a run "
      "counts once in tests, models and intervals, however often it is repeated";
  CHECK_THAT(terminal_report(findings, "r.db"), Contains("\n" + words + "\n"));
  CHECK_THAT(made.html(), Contains("72 of 108 runs repeat another one, bit by bit"));
  CHECK_THAT(terminal_answers(findings, answer(findings, {{"speed"}, {}, {}})),
             Contains("\nnote: " + words + "\n"));
  const auto same = nlohmann::json::parse(json_report(findings))["same_runs"];
  CHECK(same["copies"] == 72);
  CHECK(same["factors"][0]["some_same"] == 0);
  CHECK(same["factors"][2]["factor"] == "noise");
  CHECK(same["factors"][2]["cases"] == 36);
  CHECK(same["factors"][2]["all_same"] == 36);
  CHECK_THAT(terminal_report(Made(by_factor()).findings(), "r.db"), !Contains("bit by bit"));
}

TEST_CASE("A factor whose levels made runs fail is not said to have no effect on any run") {
  MadeExperiment study = with_noise(by_factor());
  study.cells.back().runs.front().end_as("fault");
  CHECK_THAT(terminal_report(Made(study).findings(), "r.db"),
             Contains("'noise' had no effect on any run that ended normally; a run"));
}

TEST_CASE("A factor without effect changes no model, comparison or interval of the others") {
  const Findings plain = Made(mixed()).findings(), noisy = Made(with_noise(mixed())).findings();
  SECTION("a linear model") {
    const auto fit_of = [](const Findings& findings) {
      return std::get<LinearFit>(factor_model(findings, "path_length_m ~ speed + coordinator").fit);
    };
    const LinearFit once = fit_of(plain), thrice = fit_of(noisy);
    CHECK(thrice.freedom == once.freedom);
    CHECK(thrice.adjusted_r_squared == Approx(once.adjusted_r_squared));
    CHECK(*thrice.f == Approx(*once.f));
    for (std::size_t i = 0; i < once.coefficients.size(); ++i) {
      CHECK(thrice.coefficients[i].estimate == Approx(once.coefficients[i].estimate));
      CHECK(thrice.coefficients[i].error == Approx(once.coefficients[i].error));
    }
    const FactorModel all = factor_model(noisy, "path_length_m ~ speed + coordinator + noise");
    CHECK(all.runs == 72);
    CHECK(std::get<LinearFit>(all.fit).coefficients[3].estimate == 0.0);
    CHECK_THAT(fit_in_words(all), Catch::StartsWith("72 different runs; "));
  }
  SECTION("a logistic model and its groups") {
    const FactorModel once = factor_model(plain, "success ~ speed + coordinator");
    const FactorModel thrice = factor_model(noisy, "success ~ speed + coordinator");
    const auto &a = std::get<LogisticFit>(once.fit), &b = std::get<LogisticFit>(thrice.fit);
    CHECK(b.deviance == Approx(a.deviance));
    CHECK(b.null_deviance == Approx(a.null_deviance));
    CHECK(b.freedom == a.freedom);
    CHECK(b.p == Approx(a.p));
    for (std::size_t i = 0; i < a.coefficients.size(); ++i) {
      CHECK(b.coefficients[i].estimate == Approx(a.coefficients[i].estimate));
      CHECK(b.coefficients[i].error == Approx(a.coefficients[i].error));
    }
    CHECK(rate_groups(thrice)[0].interval.low == Approx(rate_groups(once)[0].interval.low));
  }
  SECTION("comparisons") {
    const auto once = compare(plain, kFusionCells, kArbitrationCells);
    const auto thrice = compare(noisy, kFusionCells, kArbitrationCells);
    REQUIRE(once.size() == thrice.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      CAPTURE(once[i].response.name);
      CHECK(thrice[i].pooled_p == Approx(once[i].pooled_p));
      CHECK(thrice[i].paired.p == Approx(once[i].paired.p));
      CHECK(thrice[i].effect.interval->low == Approx(once[i].effect.interval->low));
    }
  }
  SECTION("correction: levels with the same runs are no comparison") {
    const auto once = level_contrasts(plain, response_of(plain, "success"));
    const auto thrice = level_contrasts(noisy, response_of(noisy, "success"));
    REQUIRE(thrice.size() == once.size() + 3);
    for (std::size_t i = 0; i < once.size(); ++i) {
      CHECK(thrice[i].paired_holm == Approx(once[i].paired_holm));
    }
    CHECK(thrice.back().same);
    CHECK(contrast_table(thrice, false).back() ==
          std::vector<std::string>{"noise=0.3", "0.1", "the same runs"});
  }
  SECTION("intervals of rates and of medians") {
    const auto fusion = [](const Findings& findings, const std::string& name) {
      return margin_of(findings, response_of(findings, name),
                       varied_factors(findings.results)[1].cells_at(1));
    };
    for (const std::string name : {"success", "time_s"}) {
      CAPTURE(name);
      const Margin once = fusion(plain, name), thrice = fusion(noisy, name);
      CHECK(once.effective == 36.0);
      CHECK(thrice.runs == 108);
      CHECK(thrice.effective == Approx(36.0));
      CHECK(thrice.centre == once.centre);
      CHECK(thrice.interval->low == Approx(once.interval->low));
      CHECK(thrice.interval->high == Approx(once.interval->high));
    }
  }
}

TEST_CASE("A comparison of the same runs is refused") {
  const Made made(with_noise(by_factor()));
  CHECK_THAT(refusal(made.findings(), {{}, {{"noise=0", "noise=0.1"}}, {}}),
             Contains("the runs of 'noise=0' and 'noise=0.1' are the same, bit by bit"));
}

TEST_CASE("Where a factor has an effect on some runs only, the others still count once") {
  MadeExperiment study = with_noise(by_factor());
  for (std::size_t cell = 0; cell < 3; ++cell) {  // 0.4 with arbitration
    for (MadeRun& run : study.cells[cell].runs) {
      run.state_hash += ", noise " + study.cells[cell].levels.back();
    }
  }
  const Findings findings = Made(study).findings();
  CHECK_THAT(terminal_report(findings, "r.db"),
             Contains("60 of 108 runs repeat another one, bit by bit: levels of 'noise' gave the "
                      "same run in 30 of 36 combinations of seed and other levels;"));
  const Margin fast = margin_of(findings, response_of(findings, "success"), {0, 1, 2, 3, 4, 5});
  CHECK(fast.runs == 36);
  CHECK(fast.effective == Approx(36.0 * 36.0 / (18 * 1 + 6 * 9)));
  CHECK_FALSE(level_contrasts(findings, response_of(findings, "success")).back().same);
}

TEST_CASE("If only a measure is varied, its values of the same run are no copies") {
  MadeExperiment study = with_noise(by_factor());
  for (MadeCell& cell : study.cells) {
    for (MadeRun& run : cell.runs) run.measures["price"] = std::stod(cell.levels.back());
  }
  const Made made(study);
  const Findings findings = made.findings();
  CHECK_FALSE(level_contrasts(findings, response_of(findings, "price")).back().same);
  CHECK(level_contrasts(findings, response_of(findings, "path_length_m")).back().same);
}

TEST_CASE("An expectation that compares the same runs knows their difference, and says why") {
  elsie::experiment::Expectation expectation =
      expectation_of("no worse with noise", "success", Statistic::rate);
  expectation.where = {{"speed", {"0.4"}}, {"coordinator", {"arbitration"}}, {"noise", {"0.3"}}};
  expectation.relation = Relation::difference;
  expectation.reference = {{"noise", "0"}};
  expectation.at_least = 0.0;
  expectation.confidence = 0.95;
  const Claim claim =
      Made(with_noise(by_factor()), expecting(expectation)).findings().verdicts[0].claims.at(0);
  CHECK(claim.holds);
  CHECK(claim.interval == Interval{0.0, 0.0});
  CHECK_THAT(claim.sentence, Contains("; the same runs, bit by bit; 95 % interval from 0 to 0)"));
}

TEST_CASE("The effects of all factors stand in one line at the top, the largest first") {
  SECTION("of success, with what may be chance and what is nothing") {
    const Made made(with_noise(by_factor(12)));
    const Findings findings = made.findings();
    // By hand: 1 less 18 of 24, and 1 less 30 of 36. Six of twelve seeds differ in success between
    // two of three speeds: 3 * 2 / 64; between the coordinators: 2 / 64.
    const std::string line =
        "peed moves success by 0.25 (which may be chance), coordinator by 0.17, noise by nothing";
    CHECK_THAT(terminal_report(findings, "r.db"), Contains("12 seeds\ns" + line + "\n\n"));
    CHECK_THAT(made.html(), Contains("<p class=\"lead\">S" + line + ".</p>"));
    const auto effects = nlohmann::json::parse(json_report(findings))["effects"];
    CHECK(effects["measure"] == "success");
    CHECK(effects["factors"][0]["factor"] == "speed");
    CHECK(effects["factors"][0]["p"] == Approx(3.0 * 2.0 / 64.0));
    CHECK(effects["factors"][1]["size"] == Approx(1.0 / 6.0));
    CHECK(effects["factors"][1]["may_be_chance"] == false);
    CHECK(effects["factors"][2]["size"] == 0.0);
    CHECK(effects["factors"][2]["p"].is_null());
  }
  SECTION("of the first measure that differs, if success does not") {
    MadeExperiment study = by_factor(12);
    for (MadeCell& cell : study.cells) {
      for (MadeRun& run : cell.runs) run.outcome = "success";
    }
    CHECK_THAT(terminal_report(Made(study).findings(), "r.db"),
               Contains("\nspeed moves path length by 6 m, coordinator by 2 m\n"));
  }
  SECTION("none, if nothing is varied or nothing is done") {
    MadeExperiment study = by_factor();
    study.cells.resize(1);
    CHECK_THAT(terminal_report(Made(study).findings(), "r.db"), !Contains(" moves "));
  }
}
