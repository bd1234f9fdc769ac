#include <cmath>

#include <nlohmann/json.hpp>

#include "elsie/files/clean_text.h"
#include "elsie/report/report.h"

#include "copies.h"
#include "effects.h"
#include "words.h"

namespace elsie::report {

namespace {

using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json json_of(const std::optional<Interval>& interval) {
  return interval ? Json::array({interval->low, interval->high}) : Json(nullptr);
}

Json json_of(const std::optional<Summary>& summary) {
  if (!summary) {
    return nullptr;
  }
  return {{"count", summary->count},
          {"mean", summary->mean},
          {"standard_deviation", or_null(summary->standard_deviation)},
          {"least", summary->least},
          {"lower_quartile", summary->lower_quartile},
          {"median", summary->median},
          {"upper_quartile", summary->upper_quartile},
          {"largest", summary->largest}};
}

// The known statistics of a sample with bounds.
Json json_of(const MeasureFindings& found) {
  const Censoring& censoring = *found.censoring;
  std::optional<Interval> interval = censoring.median_interval;
  if (interval && !std::isfinite(interval->high)) {
    interval.reset();
  }
  return {{"count", found.values.size()},
          {"censored", censoring.count},
          {"failed", censoring.failures},
          {"limit", or_null(censoring.limit)},
          {"mean", nullptr},
          {"median", or_null(censoring.median)},
          {"median_interval", json_of(interval)},
          {"successes", json_of(found.successes)}};
}

Json json_of(const Findings& findings, std::size_t place) {
  const Results& results = findings.results;
  const CellFindings& cell = findings.cells[place];
  Json levels = Json::object();
  for (std::size_t i = 0; i < results.factors.size(); ++i) {
    levels[files::clean(results.factors[i].name)] = files::clean(results.cells[place].levels[i]);
  }
  Json measures = Json::object();
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    const MeasureFindings& found = cell.measures[i];
    Json of_all = found.censoring ? json_of(found) : json_of(found.all);
    if (found.all) {
      of_all["censored"] = 0;
      of_all["interval"] = json_of(found.interval);
      of_all["fences"] = json_of(found.fences);
      of_all["successes"] = json_of(found.successes);
    }
    measures[files::clean(results.measures[findings.measures[i]].name)] = std::move(of_all);
  }
  Json outliers = Json::array();
  for (const Outlier& outlier : cell.outliers) {
    const Run& run = results.runs[outlier.run];
    outliers.push_back({{"run", run.id},
                        {"seed", run.seed},
                        {"measure", files::clean(results.measures[outlier.measure].name)},
                        {"value", outlier.value}});
  }
  return {{"label", files::clean(results.cells[place].label)},
          {"levels", std::move(levels)},
          {"ended", cell.ended},
          {"goals", cell.goals},
          {"one_run", cell.one_run},
          {"successes", cell.goals ? Json(cell.successes) : Json(nullptr)},
          {"success_interval", cell.goals ? json_of(std::optional(cell.success)) : Json(nullptr)},
          {"broken", cell.broken.size()},
          {"pending", cell.pending},
          {"measures", std::move(measures)},
          {"outliers", std::move(outliers)}};
}

Json json_of(const Findings& findings, const Verdict& verdict) {
  Json claims = Json::array();
  for (const Claim& claim : verdict.claims) {
    claims.push_back({{"cell", files::clean(findings.results.cells[claim.cell].label)},
                      {"met", claim.open ? Json(nullptr) : Json(claim.holds)},
                      {"value", or_null(claim.value)},
                      {"interval", json_of(claim.interval)},
                      {"sentence", files::clean(claim.sentence)}});
  }
  return {
      {"name", files::clean(verdict.name)},
      {"met", verdict.open() ? Json(nullptr) : Json(verdict.met())},
      {"expected", files::clean(verdict.expected)},
      {"trouble", verdict.trouble.empty() ? Json(nullptr) : Json(files::clean(verdict.trouble))},
      {"cells", std::move(claims)}};
}

Json json_of(const std::optional<Effect>& effect) {
  return effect ? Json{{"value", effect->value}, {"interval", json_of(effect->interval)}}
                : Json(nullptr);
}

// An upper end that is not known is null.
Json json_of(const Margin& margin) {
  Json interval = json_of(margin.interval);
  if (margin.interval && !std::isfinite(margin.interval->high)) {
    interval[1] = nullptr;
  }
  return {{"runs", margin.runs},
          {"effective_runs", margin.effective},
          {"seeds", margin.seeds},
          {"dropped_seeds", margin.dropped_seeds},
          {"dropped_cells", margin.dropped_cells},
          {"censored", margin.cut_off},
          {"median", margin.median},
          {"centre", or_null(margin.centre)},
          {"interval", std::move(interval)}};
}

Json json_of(const Contrast& one) {
  const auto p = [&](double value) { return one.is_tested() ? Json(value) : Json(nullptr); };
  return {
      {"measure", files::clean(one.response.name)},
      {"first", json_of(one.of_first)},
      {"second", json_of(one.of_second)},
      {"seeds", one.seeds},
      {"same_runs", one.same},
      {"difference", or_null(one.difference)},
      {"difference_interval", json_of(one.interval)},
      {"seed_test", "signed_rank"},
      {"seed_p", p(one.paired.p)},
      {"seed_p_holm", p(one.paired_holm)},
      {"pooled_test", one.response.measure ? "rank" : "fisher"},
      {"pooled_p", p(one.pooled_p)},
      {"pooled_p_holm", p(one.pooled_holm)},
      {one.response.measure ? "cliffs_delta" : "odds_ratio", json_of(std::optional(one.effect))},
      {"hedges_g", json_of(one.g)},
      {"notes", one.notes}};
}

Json json_of(const FactorModel& model) {
  const auto coefficients = [](const auto& fit) {
    Json all = Json::array();
    for (const Coefficient& one : fit.coefficients) {
      all.push_back({{"term", files::clean(one.name)},
                     {"estimate", one.estimate},
                     {"error", one.error},
                     {"interval", json_of(std::optional(one.interval))},
                     {"p", one.p},
                     {"inflation", or_null(one.inflation)}});
    }
    return all;
  };
  Json json = {{"formula", files::clean(model.formula)}, {"runs", model.runs}};
  if (const auto* linear = std::get_if<LinearFit>(&model.fit)) {
    json["coefficients"] = coefficients(*linear);
    json["r_squared"] = linear->r_squared;
    json["adjusted_r_squared"] = linear->adjusted_r_squared;
    json["residual_deviation"] = linear->deviation;
    json["f"] = or_null(linear->f);
    json["p"] = linear->p;
  } else {
    const auto& logistic = std::get<LogisticFit>(model.fit);
    json["coefficients"] = coefficients(logistic);
    for (Json& one : json["coefficients"]) {
      const std::string term = one["term"];
      if (std::any_of(logistic.separated.begin(), logistic.separated.end(),
                      [&](const std::string& name) { return files::clean(name) == term; })) {
        one["estimate"] = one["error"] = one["interval"] = one["p"] = nullptr;
      }
    }
    json["deviance"] = logistic.deviance;
    json["null_deviance"] = logistic.null_deviance;
    json["p"] = logistic.p;
    json["separated"] = logistic.separated;
    json["rates"] = Json::array();
    for (const RateGroup& group : rate_groups(model)) {
      json["rates"].push_back({{"fitted", group.fitted},
                               {"observed", group.observed.rate()},
                               {"interval", json_of(std::optional(group.interval))},
                               {"runs", group.observed.trials}});
    }
  }
  json["warnings"] = model.warnings;
  return json;
}

Json copies_json(const Findings& findings) {
  Json factors = Json::array();
  for (const Copies& one : copies_by_factor(findings)) {
    factors.push_back({{"factor", files::clean(one.factor)},
                       {"cases", one.cases},
                       {"all_same", one.all_same},
                       {"some_same", one.some_same}});
  }
  return {{"copies", count_copies(findings)}, {"factors", std::move(factors)}};
}

Json effects_json(const Findings& findings) {
  const auto effects = factor_effects(findings);
  if (!effects) {
    return nullptr;
  }
  Json factors = Json::array();
  for (const FactorEffect& one : effects->factors) {
    factors.push_back({{"factor", files::clean(one.factor)},
                       {"size", or_null(one.size)},
                       {"p", or_null(one.p)},
                       {"may_be_chance", one.may_be_chance()},
                       {"confounded", one.confounded}});
  }
  return {{"measure", files::clean(effects->response.name)}, {"factors", std::move(factors)}};
}

// Members that are there only if they were asked for.
void add_answers(const Findings& findings, const Answers& answers, Json& all) {
  if (!answers.by.empty()) {
    const std::vector<Response> shown = responses(findings);
    Json rows = Json::array();
    for (const LevelRow& row : answers.levels) {
      Json levels = Json::object(), margins = Json::object();
      for (std::size_t i = 0; i < answers.by.size(); ++i) {
        levels[files::clean(answers.by[i])] = files::clean(row.levels[i]);
      }
      for (std::size_t i = 0; i < shown.size(); ++i) {
        margins[files::clean(shown[i].name)] = json_of(row.margins[i]);
      }
      rows.push_back(
          {{"levels", std::move(levels)}, {"cells", row.cells}, {"measures", std::move(margins)}});
    }
    all["by"] = std::move(rows);
    all["by_notes"] = answers.by_notes;
  }
  if (!answers.comparisons.empty()) {
    Json comparisons = Json::array();
    for (const std::vector<Contrast>& comparison : answers.comparisons) {
      Json measures = Json::array();
      for (const Contrast& one : comparison) {
        measures.push_back(json_of(one));
      }
      comparisons.push_back({{"first", files::clean(comparison.front().first)},
                             {"second", files::clean(comparison.front().second)},
                             {"measures", std::move(measures)}});
    }
    all["comparisons"] = std::move(comparisons);
  }
  if (!answers.models.empty()) {
    Json models = Json::array();
    for (const FactorModel& model : answers.models) {
      models.push_back(json_of(model));
    }
    all["models"] = std::move(models);
  }
}

}  // namespace

std::string json_report(const Findings& findings, const Answers& answers) {
  const Results& results = findings.results;
  Json measures = Json::array();
  for (const std::size_t place : findings.measures) {
    const Measure& measure = results.measures[place];
    measures.push_back({{"name", files::clean(measure.name)},
                        {"unit", files::clean(measure.unit)},
                        {"meaning", files::clean(measure.meaning)}});
  }
  Json cells = Json::array();
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    cells.push_back(json_of(findings, i));
  }
  Json expectations = Json::array();
  for (const Verdict& verdict : findings.verdicts) {
    expectations.push_back(json_of(findings, verdict));
  }
  Json failures = Json::array();
  for (const Run& run : results.runs) {
    if (!run.broken()) {
      continue;
    }
    failures.push_back({{"run", run.id},
                        {"cell", files::clean(results.cells[run.cell].label)},
                        {"seed", run.seed},
                        {"state", to_string(run.state)},
                        {"ending", files::clean(ending_in_words(run))}});
  }
  Json disagreements = Json::array();
  for (const Disagreement& disagreement : findings.disagreements) {
    Json runs = Json::array();
    for (const std::size_t run : disagreement.runs) {
      runs.push_back(results.runs[run].id);
    }
    disagreements.push_back(std::move(runs));
  }
  Json give_ups = Json::array();
  for (const Run& run : results.runs) {
    if (run.solver_gave_up.value_or(0) > 0) {
      give_ups.push_back({{"run", run.id},
                          {"cell", files::clean(results.cells[run.cell].label)},
                          {"seed", run.seed},
                          {"gave_up_steps", *run.solver_gave_up},
                          {"unsolved_steps", run.solver_unsolved.value_or(0)}});
    }
  }
  Json all = {{"experiment", files::clean(results.experiment)},
              {"description", files::clean(results.description)},
              {"file", files::clean(results.file)},
              {"fingerprint", files::clean(results.fingerprint)},
              {"shard", files::clean(results.shard)},
              {"good", findings.good()},
              {"runs", findings.runs()},
              {"broken", findings.broken()},
              {"pending", findings.pending()},
              {"missing", findings.missing()},
              {"same_runs", copies_json(findings)},
              {"effects", effects_json(findings)},
              {"confidence", kConfidence},
              {"measures", std::move(measures)},
              {"cells", std::move(cells)},
              {"expectations", std::move(expectations)},
              {"failures", std::move(failures)},
              {"solver_give_ups", std::move(give_ups)},
              {"disagreements", std::move(disagreements)}};
  add_answers(findings, answers, all);
  return all.dump(2) + '\n';
}

}  // namespace elsie::report
