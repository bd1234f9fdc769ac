// The results by factor.
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "by_factor.h"
#include "fixture.h"

using namespace elsie::report;
using Catch::Contains;
using namespace elsie::test;

namespace {

// The study of by_factor(), written and read once.
struct ByFactor {
  static const Made& made() {
    static const Made study(by_factor());
    return study;
  }
  static const Findings& found() {
    static const Findings all = made().findings();
    return all;
  }

  const Findings& findings = found();
  const std::vector<VariedFactor> factors = varied_factors(findings.results);
};

}  // namespace

TEST_CASE_METHOD(ByFactor,
                 "Levels that are numbers are in their order, others in that of the experiment") {
  REQUIRE(factors.size() == 2);  // the one world is not varied
  CHECK(factors[0].name == "speed");
  CHECK(factors[0].levels == std::vector<std::string>{"0.1", "0.2", "0.4"});
  CHECK(factors[0].numbers == std::vector<double>{0.1, 0.2, 0.4});
  CHECK(factors[0].cells_at(2) == std::vector<std::size_t>{0, 1});
  CHECK(factors[1].levels == std::vector<std::string>{"arbitration", "fusion"});
  CHECK_FALSE(factors[1].numeric());
}

TEST_CASE_METHOD(ByFactor, "A margin is the mean over cells, with each seed as one observation") {
  const Margin fusion =
      margin_of(findings, response_of(findings, "path_length_m"), factors[1].cells_at(1));
  CHECK(fusion.runs == 18);
  // By hand: 10 - 20 * (0.1 + 0.2 + 0.4) / 3 + 2 + 0.35.
  CHECK(fusion.centre == Approx(10.0 - 14.0 / 3.0 + 2.35));
  const std::vector<double> seeds{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
  const auto around = mean_interval(seeds, 0.95, findings.results.seed(), "path_length_m");
  CHECK(fusion.interval->low == Approx(around->low - 0.35 + *fusion.centre));
}

TEST_CASE_METHOD(ByFactor, "A margin of success is the rate of all runs, with Wilson's interval") {
  const Margin margin =
      margin_of(findings, response_of(findings, "success"), factors[1].cells_at(0));
  CHECK(margin.centre == Approx(15.0 / 18.0));
  CHECK(*margin.interval == wilson_interval(15, 18, 0.95));
}

TEST_CASE_METHOD(ByFactor, "A margin of times that a limit cut off is their median") {
  const Margin fast = margin_of(findings, response_of(findings, "time_s"), {0});
  CHECK(fast.cut_off == 3);
  CHECK_FALSE(fast.centre);  // half of six remain to the end
  CHECK_FALSE(fast.at_least);
  const Margin all = margin_of(findings, response_of(findings, "time_s"), factors[1].cells_at(0));
  // Known: 14.5, 16.5, 18.5, 26 ... 31, 51 ... 56: the ninth and tenth of 18 are 31 and 51.
  CHECK(all.centre == Approx(41.0));
}

TEST_CASE("Where the limit cut off all runs, the chart of a factor has an arrow from the limit") {
  MadeExperiment study = by_factor();
  for (auto& run : study.cells[0].runs) {
    run.outcome = "time_limit";
    run.measures["time_s"] = 60.0;
  }
  const Made made(study);
  const Margin none = margin_of(made.findings(), response_of(made.findings(), "time_s"), {0});
  CHECK_FALSE(none.centre);
  CHECK(none.at_least == 60.0);
}

TEST_CASE("A level of which most runs were cut off still has a bound") {
  MadeExperiment study = by_factor();
  for (std::size_t cell = 0; cell < 2; ++cell) {  // speed 0.4
    for (auto& run : study.cells[cell].runs) {
      if (cell == 1 && run.seed == 1) continue;
      run.outcome = "time_limit";
      run.measures["time_s"] = 60.0;
    }
  }
  const Made made(study);
  const Findings findings = made.findings();
  const Response time = response_of(findings, "time_s");
  const Balance balance = balanced(findings, time, {{0, 1}}, {});
  const Margin margin = margin_of(findings, time, balance, 0);
  CHECK_FALSE(margin.centre);
  CHECK(margin.cut_off == 11);
  CHECK((margin.interval ? margin.interval->low > 0.0 : margin.at_least == 60.0));
}

TEST_CASE("A run that fails before the limit never reaches its goals") {
  MadeExperiment study = by_factor();
  study.cells[1].runs[0].outcome = "failure";
  study.cells[1].runs[0].measures["time_s"] = 1.0;
  study.cells[1].runs[1].end_as("crash");
  const Made made(study);
  const auto times = times_to_goals(made.findings(), 1);
  REQUIRE(times.size() == 5);  // the crashed one has no time
  CHECK(times[0].bound);
  CHECK(times[0].value == 18.5);  // at risk as long as the longest
  CHECK_FALSE(times[1].bound);
}

TEST_CASE_METHOD(ByFactor,
                 "Cells are compared seed by seed with those that match in all other factors") {
  const auto all = compare(findings, "coordinator=fusion", "coordinator=arbitration");
  const auto of = [&](const std::string& name) {
    return *std::find_if(all.begin(), all.end(),
                         [&](const Contrast& one) { return one.response.name == name; });
  };
  const Contrast path = of("path_length_m");
  CHECK(path.seeds == 6);
  CHECK(path.difference == Approx(2.0));
  CHECK(path.paired.p == Approx(2.0 / 64.0));  // all six are above
  CHECK(path.g.has_value());
  const Contrast success = of("success");
  CHECK(success.difference == Approx(3.0 / 18.0));
  CHECK(success.paired.p == Approx(2.0 / 8.0));  // three seeds differ
  CHECK(success.pooled_p == Approx(fisher_test({18, 18}, {15, 18})));
  const Contrast time = of("time_s");
  CHECK_FALSE(time.difference);
  CHECK_FALSE(time.g);
  CHECK(time.paired.below == 3);
  CHECK(time.paired.above == 0);
  CHECK(of("collisions").equal);
}

TEST_CASE("The test by seed counts in how many cells success differs, not only its sign") {
  // Fusion succeeds in all three cells of five seeds, arbitration in none of them; with seed 6,
  // arbitration succeeds in one cell more.
  MadeExperiment study = by_factor();
  for (auto& cell : study.cells) {
    for (auto& run : cell.runs) {
      const bool fusion = cell.levels[2] == "fusion";
      const bool success = run.seed == 6 ? !fusion && cell.levels[1] == "0.1" : fusion;
      run.outcome = success ? "success" : "time_limit";
    }
  }
  const Made made(study);
  const Findings findings = made.findings();
  const Contrast success =
      compare(findings, "coordinator=fusion", "coordinator=arbitration").front();
  REQUIRE(success.response.name == "success");
  // Five of the ranks 4 for fusion, and rank 1: 2 of 64 signs go as far or farther on each side.
  // Signs alone would have 14 of 64.
  CHECK(success.paired.p == Approx(4.0 / 64.0));
}

TEST_CASE_METHOD(ByFactor, "Intervals beside corrected p-values are said not to be corrected") {
  const std::pair<std::string, std::string> groups{"coordinator=fusion", "coordinator=arbitration"};
  CHECK_THAT(terminal_answers(findings, answer(findings, {{}, {groups}, {}})),
             Contains("corrected for all comparisons of a measure (Holm). The 95 % intervals\n"
                      "are not corrected"));
  CHECK_THAT(made().html(), Contains("intervals are not corrected"));
}

TEST_CASE_METHOD(ByFactor, "All pairs of levels are compared, and corrected together") {
  const auto contrasts = level_contrasts(findings, response_of(findings, "path_length_m"));
  REQUIRE(contrasts.size() == 4);  // three pairs of speeds, one of coordinators
  CHECK(contrasts[0].first == "speed=0.2");
  CHECK(contrasts[0].second == "0.1");
  CHECK(contrasts[0].difference == Approx(-2.0));
  for (const Contrast& one : contrasts) CHECK(one.paired_holm == Approx(4.0 * 2.0 / 64.0));
}

TEST_CASE_METHOD(ByFactor,
                 "A model has the coefficients of the study; numbers count from their mean") {
  const FactorModel model = factor_model(findings, "path_length_m ~ speed + coordinator");
  const auto& fit = std::get<LinearFit>(model.fit);
  REQUIRE(fit.coefficients.size() == 3);
  CHECK(fit.coefficients[0].estimate == Approx(10.0 - 14.0 / 3.0 + 0.35));
  CHECK(fit.coefficients[1].estimate == Approx(-20.0));
  CHECK(fit.coefficients[2].name == "coordinator=fusion");
  CHECK(fit.coefficients[2].estimate == Approx(2.0));
  CHECK(model.warnings.empty());
}

TEST_CASE_METHOD(ByFactor, "a * b is a + b + a:b, and each product stands once") {
  const auto names = [&](const std::string& formula) {
    std::vector<std::string> all;
    const FactorModel model = factor_model(findings, formula);
    for (const Coefficient& one : std::get<LinearFit>(model.fit).coefficients) {
      all.push_back(one.name);
    }
    return all;
  };
  const std::vector<std::string> crossed{"", "speed", "coordinator=fusion",
                                         "speed : coordinator=fusion"};
  CHECK(names("path_length_m ~ speed * coordinator") == crossed);
  CHECK(names("path_length_m~speed+coordinator+coordinator:speed+speed") == crossed);
}

TEST_CASE_METHOD(ByFactor, "A product of a factor with itself is refused") {
  for (const char* formula : {"success ~ speed:speed", "success ~ speed*coordinator*speed"}) {
    CHECK_THROWS_WITH(factor_model(findings, formula), Contains("has the factor 'speed' twice"));
  }
}

TEST_CASE_METHOD(ByFactor, "Separation by a level is said") {
  const FactorModel model = factor_model(findings, "success ~ coordinator");
  REQUIRE(model.warnings.size() == 1);
  CHECK_THAT(model.warnings[0],
             Contains("'coordinator=fusion' has no finite coefficient") && Contains("separation"));
  CHECK(coefficient_table(model)[2][1] == "∞");
}

TEST_CASE("Fitted rates of success are compared with observed ones") {
  // Success becomes more likely with the speed: seed s succeeds from level s on.
  MadeExperiment study;
  study.name = "Rates";
  study.factors = {"world", "speed"};
  for (std::size_t level = 1; level <= 24; ++level) {
    auto& cell = study.cells.emplace_back();
    cell.label = std::to_string(level);
    cell.levels = {"w", cell.label};
    cell.world_text = elsie::test::made_world();
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      auto& run = cell.runs.emplace_back();
      run.seed = seed;
      const bool success = seed <= level;
      run.outcome = success ? "success" : "time_limit";
      run.measures = {{"success", success ? 1.0 : 0.0}, {"time_s", static_cast<double>(seed)}};
      run.robots.emplace_back().poses = {{0, 0, 0},
                                         {0.1 * static_cast<double>(level + seed), 0, 0}};
    }
  }
  const auto groups_of = [](const MadeExperiment& experiment) {
    return rate_groups(factor_model(Made(experiment).findings(), "success ~ speed"));
  };
  const std::vector<RateGroup> groups = groups_of(study);
  REQUIRE(groups.size() <= kMostRateGroups);
  REQUIRE(groups.size() >= 7);
  for (const RateGroup& group : groups) CHECK(group.observed.trials <= 60);
  std::size_t runs = 0, hits = 0;
  double expected = 0.0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    CHECK((i == 0 || groups[i].fitted > groups[i - 1].fitted));
    CHECK(groups[i].interval.low <= groups[i].observed.rate());
    CHECK(groups[i].observed.rate() <= groups[i].interval.high);
    CHECK(groups[i].observed.rate() == Approx(groups[i].fitted).margin(0.1));
    runs += groups[i].observed.trials;
    hits += groups[i].observed.hits;
    expected += groups[i].fitted * static_cast<double>(groups[i].observed.trials);
  }
  CHECK(runs == 24 * 20);
  CHECK(expected == Approx(static_cast<double>(hits)));  // as the likelihood equations say
  SECTION("in ten groups of eleven rates") {
    study.cells.resize(11);
    CHECK(groups_of(study).size() == 10);
  }
  SECTION("of each rate, where there are few") {
    study.cells.resize(8);
    const std::vector<RateGroup> few = groups_of(study);
    REQUIRE(few.size() == 8);
    for (std::size_t i = 0; i < few.size(); ++i) {
      CHECK(few[i].observed.hits == i + 1);
      CHECK(few[i].observed.trials == 20);
    }
  }
}

TEST_CASE("Levels are compared with one that has successes and failures") {
  MadeExperiment study = by_factor();
  for (auto& cell : study.cells) {
    for (auto& run : cell.runs) {
      const bool late = cell.levels[2] == "arbitration" || run.seed == 1;
      run.outcome = late ? "time_limit" : "success";
    }
  }
  const Made made(study);
  const FactorModel model = factor_model(made.findings(), "success ~ coordinator");
  const auto& fit = std::get<LogisticFit>(model.fit);
  CHECK(fit.coefficients[1].name == "coordinator=arbitration");
  CHECK(fit.coefficients[0].estimate == Approx(std::log(5.0)));  // fusion: 15 of 18
  CHECK(fit.separated == std::vector<std::string>{"coordinator=arbitration"});
  CHECK_THAT(model.warnings.back(), Contains("'coordinator' are compared with 'fusion'"));
  SECTION("unless no level has both") {
    for (auto& cell : study.cells) {
      for (auto& run : cell.runs) {
        run.outcome = cell.levels[2] == "fusion" ? "success" : "time_limit";
      }
    }
    const FactorModel all = factor_model(Made(study).findings(), "success ~ coordinator");
    CHECK_THAT(all.warnings[0], Contains("no coefficient can be estimated"));
    CHECK(coefficient_table(all)[2][1] == "-");
    CHECK(std::get<LogisticFit>(all.fit).coefficients[1].name == "coordinator=fusion");
  }
}

TEST_CASE_METHOD(ByFactor,
                 "If some runs have only bounds, all centres of the measure are medians") {
  const Answers answers = answer(findings, {{"coordinator"}, {}, {}});
  const auto& fusion = answers.levels[1].margins[2];  // of the times
  CHECK(fusion.cut_off == 0);
  CHECK(fusion.median);
  CHECK(fusion.centre == Approx(28.5));  // 13.5 ... 18.5, 26 ... 31, 51 ... 56
  CHECK_THAT(terminal_answers(findings, answers), Contains("median 28.5"));
  CHECK_THAT(made().html(), Contains(">median time (s)</text>"));
}

TEST_CASE_METHOD(ByFactor, "What cannot be answered is refused in a sentence") {
  const auto compared = [&](const std::string& a, const std::string& b) {
    return refusal(findings, {{}, {{a, b}}, {}});
  };
  const auto model = [&](const std::string& formula) {
    return refusal(findings, {{}, {}, {formula}});
  };
  CHECK_THAT(refusal(findings, {{"speeds"}, {}, {}}),
             Contains("no factor 'speeds' is varied") && Contains("speed"));
  CHECK_THAT(refusal(findings, {{"world"}, {}, {}}), Contains("no factor 'world' is varied"));
  CHECK_THAT(refusal(findings, {{"speed", "speed"}, {}, {}}), Contains("named twice"));
  CHECK_THAT(compared("0.4, fusion", "0.4, fusion"), Contains("cannot be compared with itself"));
  CHECK_THAT(compared("speed=0.4", "coordinator=fusion"),
             Contains("have the cell '0.4, fusion' in common"));
  CHECK_THAT(compared("sped=0.4", "speed=0.1"),
             Contains("there is no factor 'sped'") && Contains("speed"));
  CHECK_THAT(compared("speed=0.5", "speed=0.1"), Contains("'speed' has no level '0.5'"));
  CHECK_THAT(compared("coordinator=fusion, speed=0.1", "speed=0.4"),
             Contains("'coordinator' has no level 'fusion, speed=0.1'; separate factors by \";\""));
  CHECK_THAT(compared("slow", "speed=0.1"), Contains("there is no cell 'slow'"));
  CHECK_THAT(compared("speed=0.1; speed=0.2", "speed=0.4"), Contains("'speed' stands there twice"));
  CHECK_THAT(model("path_length_m"), Contains("is no formula"));
  CHECK_THAT(model("path ~ speed"), Contains("there is no measure 'path'"));
  CHECK_THAT(model("path_length_m ~ speed + weight"), Contains("no factor 'weight' is varied"));
  CHECK_THAT(model("path_length_m ~ speed +"),
             Contains("'speed +' lacks a factor before or after one of its signs"));
  CHECK_THAT(model("time_s ~ speed"), Contains("of 3 of 36 runs is only a bound"));
  CHECK_THAT(model("collisions ~ speed"), Contains("all 36 values are equal"));
}

TEST_CASE("A model may not have more coefficients than there are cells") {
  const Made made(made_from({{1, 2, 3}, {2, 3, 4}}));
  MadeExperiment crossed = by_factor();
  crossed.cells.resize(3);  // 0.4 with both, 0.1 with one
  const Made few(crossed);
  CHECK(refusal(made.findings(), {{}, {}, {"path_length_m ~ scheme"}}).empty());
  CHECK_THAT(refusal(few.findings(), {{}, {}, {"path_length_m ~ speed * coordinator"}}),
             Contains("has 4 coefficients, and there are 3 cells"));
}

TEST_CASE("One seed is too few for a comparison and for a model") {
  const Made made(by_factor(1));
  CHECK_THAT(refusal(made.findings(), {{}, {{"speed=0.1", "speed=0.2"}}, {}}),
             Contains("runs of 1 seed only"));
  CHECK_THAT(refusal(made.findings(), {{}, {}, {"path_length_m ~ speed"}}),
             Contains("runs of 1 seed only"));
  CHECK_THAT(made.html(), Contains("By factor"));  // the page has the effects, and says the rest
}

TEST_CASE("Equal values everywhere are nothing to compare") {
  const Made made(made_from({{3, 3, 3}, {3, 3, 3}}));
  CHECK_THAT(refusal(made.findings(), {{}, {{"a", "b"}}, {}}), Contains("equal values"));
  CHECK_THAT(made.html(), Contains("The same in every run, or in none: success, path length."));
}

TEST_CASE_METHOD(ByFactor,
                 "What was asked for is printed, and is in the JSON object and on the page") {
  const Answers answers = answer(findings, {{"coordinator"},
                                            {{"coordinator=fusion", "coordinator=arbitration"}},
                                            {"path_length_m ~ speed"}});
  const std::string text = terminal_answers(findings, answers);
  CHECK_THAT(text, Contains("arbitration       3     83 % (61 to 94)   5.683 (5.47 to 5.895)"));
  CHECK_THAT(text, Contains("coordinator=fusion   coordinator=arbitration"));
  CHECK_THAT(text, Contains("Linear model path_length_m ~ speed"));
  const auto json = nlohmann::json::parse(json_report(findings, answers));
  CHECK(json["by"].size() == 2);
  CHECK(json["by"][0]["measures"]["success"]["runs"] == 18);
  CHECK(json["comparisons"][0]["measures"][1]["difference"].get<double>() == Approx(2.0));
  CHECK(json["models"][0]["coefficients"][1]["estimate"].get<double>() == Approx(-20.0));
  CHECK_FALSE(nlohmann::json::parse(json_report(findings)).contains("by"));
  const ResultsFile file(made().path);
  CHECK_THAT(html_report(findings, file, "runs.db", "", answers),
             Contains("What was asked for") && Contains("path_length_m ~ speed"));
  CHECK(terminal_answers(findings, {}).empty());
}

TEST_CASE_METHOD(
    ByFactor, "The page shows effects, pairs, comparisons, models, curves with numbers at risk") {
  const std::string html = made().html();
  for (const char* part :
       {"<h2>By factor</h2>", "Two factors together", "Levels compared", "Logistic model",
        "Linear model", "<h2>Time until the goals</h2>", ">at risk</text>", "Medians of the cells",
        "<h2>Over time</h2>", "Brookmeyer", "deviance", "adjusted",
        "Residuals: ", "Fitted and observed rates: success ~ speed + coordinator, ",
        "No model: 'time_s' of 3 of 36 runs is only a bound"}) {
    CAPTURE(part);
    CHECK(html.find(part) != std::string::npos);
  }
  CHECK(html == made().html());
}

TEST_CASE_METHOD(ByFactor,
                 "Coefficients without a finite estimate are no numbers in the JSON object") {
  Answers answers;
  answers.models.push_back(factor_model(findings, "success ~ coordinator"));
  const auto json = nlohmann::json::parse(json_report(findings, answers));
  const auto& fusion = json["models"][0]["coefficients"][1];
  CHECK(fusion["term"] == "coordinator=fusion");
  for (const char* key : {"estimate", "error", "interval", "p"}) CHECK(fusion[key].is_null());
}

TEST_CASE("A page without factors, or without a run, has no section by factor") {
  MadeExperiment one = made_from({{1, 2, 3}});
  CHECK_THAT(Made(one).html(), !Contains("By factor"));
  MadeExperiment pending = by_factor(2);
  for (auto& cell : pending.cells) {
    for (auto& run : cell.runs) {
      run.end_as("pending");
    }
  }
  CHECK_THAT(Made(pending).html(), !Contains("By factor"));
}

TEST_CASE("Two thousand cells of three factors have figures by factor in four megabytes",
          "[release]") {
  MadeExperiment study;
  study.factors = {"world", "gain", "delay", "scheme"};
  const std::string world = elsie::test::made_world();
  for (int i = 0; i < 2000; ++i) {
    elsie::test::MadeCell& cell = study.cells.emplace_back();
    cell.levels = {"w", std::to_string(i / 200), std::to_string(i / 20 % 10),
                   "scheme " + std::to_string(i % 20)};
    cell.label = cell.levels[1] + ", " + cell.levels[2] + ", " + cell.levels[3];
    cell.world_text = world;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      elsie::test::MadeRun& run = cell.runs.emplace_back();
      run.seed = seed;
      const double value = i % 17 + 0.1 * static_cast<double>(seed * (i % 7));
      run.outcome = i % 11 == 0 ? "time_limit" : "success";
      run.measures = {{"success", i % 11 == 0 ? 0.0 : 1.0},
                      {"path_length_m", value},
                      {"time_s", i % 11 == 0 ? 99.0 : value},
                      {"energy_left", 100.0 - value},
                      {"collisions", i % 3}};
    }
  }
  const std::string html = Made(study).html();
  CHECK(html.size() < 4'000'000);
  CHECK_THAT(html, Contains("<h2>By factor</h2>") && Contains("Two factors together"));
  CHECK_THAT(html, Contains("scheme (20)"));  // too many pairs of levels to compare
}
