#include "elsie/report/factor_models.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/experiment/split.h"
#include "elsie/files/clean_text.h"

#include "copies.h"
#include "numbers.h"

namespace elsie::report {

using experiment::split;
using experiment::trimmed;

namespace {

[[noreturn]] void refuse_model(const std::string& sentence) {
  throw std::invalid_argument(sentence);
}

using Product = std::vector<std::size_t>;  // indices of varied factors, ascending

// The products that a formula's right side names, in order, each once.
std::vector<Product> products_of(const std::string& side,
                                 const std::vector<VariedFactor>& factors) {
  std::vector<std::string> names;
  for (const VariedFactor& factor : factors) {
    names.push_back(factor.name);
  }
  const auto place_of = [&](const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      refuse_model("no factor '" + files::one_line(name) + "' is varied" +
                   base::near_or_all(name, names, "there are"));
    }
    return static_cast<std::size_t>(found - names.begin());
  };
  std::vector<Product> products;
  const auto add = [&](Product product) {
    std::sort(product.begin(), product.end());
    if (const auto twice = std::adjacent_find(product.begin(), product.end());
        twice != product.end()) {
      refuse_model("a product has the factor '" + files::one_line(names[*twice]) +
                   "' twice; expected different factors, as in 'speed:coordinator'");
    }
    if (std::find(products.begin(), products.end(), product) == products.end()) {
      products.push_back(std::move(product));
    }
  };
  for (const std::string& part : split(side, '+')) {
    std::vector<Product> crossed{{}};
    for (const std::string& one : split(part, '*')) {
      Product single;
      for (const std::string& name : split(one, ':')) {
        if (name.empty()) {
          refuse_model("'" + files::one_line(trimmed(side)) +
                       "' lacks a factor before or after one of its signs + * :; expected a factor "
                       "on both sides of each, as in 'speed + coordinator'");
        }
        single.push_back(place_of(name));
      }
      for (std::size_t i = crossed.size(); i-- > 0;) {
        Product longer = crossed[i];
        longer.insert(longer.end(), single.begin(), single.end());
        crossed.push_back(std::move(longer));
      }
    }
    std::stable_sort(crossed.begin(), crossed.end(),
                     [](const auto& a, const auto& b) { return a.size() < b.size(); });
    for (std::size_t i = 1; i < crossed.size(); ++i) {
      add(crossed[i]);
    }
  }
  return products;
}

// The reference level: the first, or for success the first with both outcomes, because the log odds
// of the others are infinite.
std::size_t reference_of(const VariedFactor& factor, const Response& response,
                         const std::vector<Observation>& runs) {
  std::vector<Frequency> levels(factor.levels.size());
  for (const Observation& run : runs) {
    Frequency& level = levels[factor.of_cell[run.cell]];
    level.hits += run.of.value != 0.0 ? 1 : 0;
    ++level.trials;
  }
  const auto mixed = std::find_if(levels.begin(), levels.end(), [](const Frequency& level) {
    return level.hits > 0 && level.hits < level.trials;
  });
  return response.measure || mixed == levels.end()
             ? 0
             : static_cast<std::size_t>(mixed - levels.begin());
}

std::vector<Term> terms_of(const VariedFactor& factor, const Response& response,
                           const std::vector<Observation>& runs) {
  std::vector<Term> terms;
  const auto add = [&](const std::string& name, auto value) {
    Term term{name, {}};
    for (const Observation& run : runs) {
      term.values.push_back(value(factor.of_cell[run.cell]));
    }
    terms.push_back(std::move(term));
  };
  if (factor.numeric()) {
    add(factor.name, [&](std::size_t level) { return factor.numbers[level]; });
    std::vector<double>& values = terms.front().values;
    const double mean = *statistic_of(Statistic::mean, values);
    for (double& value : values) {
      value -= mean;
    }
    return terms;
  }
  const std::size_t reference = reference_of(factor, response, runs);
  for (std::size_t i = 0; i < factor.levels.size(); ++i) {
    if (i == reference) {
      continue;
    }
    add(factor.name + "=" + factor.levels[i],
        [&](std::size_t level) { return level == i ? 1.0 : 0.0; });
  }
  return terms;
}

std::vector<Term> product_of(const std::vector<Term>& first, const std::vector<Term>& second) {
  std::vector<Term> products;
  for (const Term& a : first) {
    for (const Term& b : second) {
      Term& product = products.emplace_back(Term{a.name + " : " + b.name, a.values});
      for (std::size_t i = 0; i < product.values.size(); ++i) {
        product.values[i] *= b.values[i];
      }
    }
  }
  return products;
}

std::string listed_terms(const std::vector<std::string>& names) {
  std::vector<std::string> texts;
  for (const std::string& name : names) {
    texts.push_back(name.empty() ? "the constant" : "'" + files::one_line(name) + "'");
  }
  return base::enumerated(texts);
}

template <class Fit>
void warn(const Fit& fit, std::vector<std::string>& warnings) {
  if (!fit.left_out.empty()) {
    warnings.push_back(listed_terms(fit.left_out) + (fit.left_out.size() == 1 ? " is" : " are") +
                       " left out: the cells do not tell " +
                       (fit.left_out.size() == 1 ? "it" : "them") +
                       " apart from the other terms (collinearity)");
  }
  std::vector<std::string> inflated;
  double most = 0.0;
  for (const Coefficient& one : fit.coefficients) {
    if (one.inflation.value_or(0.0) > kMuchInflation) {
      inflated.push_back(one.name);
      most = std::max(most, *one.inflation);
    }
  }
  if (!inflated.empty()) {
    warnings.push_back("collinearity enlarges the variance of " + listed_terms(inflated) +
                       " up to " + brief(most, 2) + " times");
  }
}

// The runs that a model may use, with what was left out.
std::vector<Observation> observations_for(const Findings& findings, const Response& response,
                                          std::vector<std::string>& warnings) {
  const Balance balance = balanced(findings, response, {all_cells(findings)}, {});
  const std::vector<Observation> runs = observations(findings, response, balance, 0, true);
  const auto bounds =
      std::count_if(runs.begin(), runs.end(), [](const auto& run) { return run.of.bound; });
  if (bounds > 0) {
    refuse_model("'" + files::one_line(response.name) + "' of " + std::to_string(bounds) + " of " +
                 counted(runs.size(), "run") +
                 " is only a bound, because they never reached their goals, and least squares "
                 "cannot use bounds; model 'success', or a measure without bounds");
  }
  if (balance.certain()) {
    refuse_model(
        "all seeds of each cell gave one and the same run: nothing is random, so a model "
        "has nothing to test; compare the values of the cells");
  }
  if (balance.seeds.size() < 2) {
    refuse_model("there are runs of " + counted(balance.seeds.size(), "seed") + " only" +
                 (balance.dropped_seeds > 0
                      ? " with a value in each cell, and a model needs at least two; do the runs "
                        "that are missing"
                      : ", and a model needs at least two; run the experiment with more seeds"));
  }
  warnings = notes_on(balance);
  return runs;
}

// Whether cells with values lack a combination of the levels that they have.
bool is_incomplete(const Findings& findings, const std::vector<VariedFactor>& factors,
                   const std::set<std::size_t>& cells) {
  std::size_t all = 1;
  std::set<std::vector<std::string>> combinations;
  for (const VariedFactor& factor : factors) {
    std::set<std::size_t> levels;
    for (const std::size_t cell : cells) {
      levels.insert(factor.of_cell[cell]);
    }
    all *= levels.size();
  }
  for (const std::size_t cell : cells) {
    combinations.insert(findings.results.cells[cell].levels);
  }
  return combinations.size() < all;
}

// The varied factors that no product names, if the grid is incomplete.
void warn_of_missing_factors(const Findings& findings, const std::vector<VariedFactor>& factors,
                             const std::vector<Product>& products,
                             const std::set<std::size_t>& cells,
                             std::vector<std::string>& warnings) {
  std::vector<std::string> missing;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const bool is_named = std::any_of(products.begin(), products.end(), [&](const Product& one) {
      return std::find(one.begin(), one.end(), i) != one.end();
    });
    if (!is_named) {
      missing.push_back(factors[i].name);
    }
  }
  if (!missing.empty() && is_incomplete(findings, factors, cells)) {
    warnings.push_back("some combinations of levels have no values, and the model leaves out " +
                       listed_terms(missing) +
                       ": effects of what is left out may show in the other coefficients");
  }
}

Response response_called(const Findings& findings, const std::string& name) {
  std::vector<std::string> names;
  for (const Response& response : responses(findings)) {
    if (response.name == name) {
      return response;
    }
    names.push_back(response.name);
  }
  refuse_model("there is no measure '" + files::one_line(name) + "'" +
               base::near_or_all(name, names, "there are"));
}

}  // namespace

FactorModel factor_model(const Findings& findings, const std::string& formula) {
  const std::size_t tilde = formula.find('~');
  if (tilde == std::string::npos || trimmed(formula.substr(tilde + 1)).empty()) {
    refuse_model("'" + files::one_line(formula) +
                 "' is no formula; expected a measure and factors, as in 'time_s ~ speed + "
                 "coordinator'");
  }
  FactorModel model;
  model.response = response_called(findings, trimmed(formula.substr(0, tilde)));
  model.formula = trimmed(formula);
  const std::vector<VariedFactor> factors = varied_factors(findings.results);
  const std::vector<Product> products = products_of(formula.substr(tilde + 1), factors);
  const std::vector<Observation> runs = observations_for(findings, model.response, model.warnings);
  std::size_t count = 1;
  for (const Product& product : products) {
    std::size_t of_product = 1;
    for (const std::size_t factor : product) {
      of_product *= factors[factor].numeric() ? 1 : factors[factor].levels.size() - 1;
    }
    count += of_product;
  }
  if (count > kMostCoefficients) {
    refuse_model("'" + files::one_line(model.formula) + "' has " + counted(count, "coefficient") +
                 ", and nobody can read more than " + std::to_string(kMostCoefficients) +
                 "; name fewer terms");
  }
  std::vector<Term> terms;
  for (const Product& product : products) {
    std::vector<Term> of_product = terms_of(factors[product.front()], model.response, runs);
    for (std::size_t i = 1; i < product.size(); ++i) {
      of_product = product_of(of_product, terms_of(factors[product[i]], model.response, runs));
    }
    terms.insert(terms.end(), of_product.begin(), of_product.end());
  }
  std::set<std::size_t> cells;
  for (const Observation& run : runs) {
    cells.insert(run.cell);
    model.cells.push_back(run.cell);
  }
  warn_of_missing_factors(findings, factors, products, cells, model.warnings);
  if (terms.size() + 1 > cells.size()) {
    refuse_model("'" + files::one_line(model.formula) + "' has " +
                 counted(terms.size() + 1, "coefficient") + ", and there are " +
                 counted(cells.size(), "cell") +
                 " with values; a model cannot have more coefficients than cells: name fewer "
                 "terms");
  }
  model.weights = shares_of(runs);
  model.runs = without_copies(runs).size();
  if (model.response.measure) {
    std::vector<double> values;
    for (const Observation& run : runs) {
      values.push_back(run.of.value);
    }
    LinearFit fit = fit_linear(terms, values, kConfidence, model.weights);
    warn(fit, model.warnings);
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    if (fit.deviation <= kRoundingOfRuns * std::max(std::abs(*least), std::abs(*largest))) {
      model.warnings.emplace_back(
          "the residuals come from rounding, so errors, intervals and p-values mean nothing");
    }
    model.fit = std::move(fit);
  } else {
    std::vector<bool> values;
    for (const Observation& run : runs) {
      values.push_back(run.of.value != 0.0);
    }
    LogisticFit fit = fit_logistic(terms, values, kConfidence, model.weights);
    warn(fit, model.warnings);
    if (fit.perfect) {
      model.warnings.emplace_back(
          "the factors tell all successes from all failures (the deviance is 0), so no coefficient "
          "can be estimated (separation)");
    } else if (!fit.separated.empty()) {
      model.warnings.push_back(listed_terms(fit.separated) +
                               (fit.separated.size() == 1 ? " has" : " have") +
                               " no finite coefficient: success is certain or impossible where it "
                               "says so (separation); the number and its interval mean nothing");
    }
    model.fit = std::move(fit);
  }
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const bool is_named = std::any_of(products.begin(), products.end(), [&](const Product& one) {
      return std::find(one.begin(), one.end(), i) != one.end();
    });
    const std::size_t reference = reference_of(factors[i], model.response, runs);
    if (is_named && !factors[i].numeric() && reference > 0) {
      model.warnings.push_back("the levels of '" + files::one_line(factors[i].name) +
                               "' are compared with '" +
                               files::one_line(factors[i].levels[reference]) +
                               "', the first with successes and failures");
    }
  }
  return model;
}

std::string main_effects(const Findings& findings, const Response& response) {
  std::string side;
  for (const VariedFactor& factor : varied_factors(findings.results)) {
    side += (side.empty() ? "" : " + ") + factor.name;
  }
  return response.name + " ~ " + side;
}

std::vector<RateGroup> rate_groups(const FactorModel& model) {
  const auto& fit = std::get<LogisticFit>(model.fit);
  constexpr double kSame = 1e-9;
  std::vector<std::size_t> order(fit.fitted.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return fit.fitted[a] < fit.fitted[b]; });
  const auto is_new = [&](std::size_t i) {
    return i > 0 && fit.fitted[order[i]] > fit.fitted[order[i - 1]] + kSame;
  };
  std::size_t rates = 1;
  for (std::size_t i = 1; i < order.size(); ++i) {
    rates += is_new(i) ? 1 : 0;
  }
  const auto tenth = [&](std::size_t i) { return i * kMostRateGroups / order.size(); };
  std::vector<RateGroup> groups;
  std::vector<double> weights;  // of the groups
  std::size_t start = 0;        // of the last group
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || (is_new(i) && (rates <= kMostRateGroups || tenth(i) != tenth(start)))) {
      groups.emplace_back();
      weights.push_back(0.0);
      start = i;
    }
    RateGroup& group = groups.back();
    group.fitted += fit.fitted[order[i]];
    group.observed.hits += fit.fitted[order[i]] + fit.residuals[order[i]] > 0.5 ? 1 : 0;
    ++group.observed.trials;
    weights.back() += model.weights[order[i]];
  }
  for (std::size_t i = 0; i < groups.size(); ++i) {
    groups[i].fitted /= static_cast<double>(groups[i].observed.trials);
    groups[i].interval =
        wilson_interval_of_rate(groups[i].observed.rate(), weights[i], kConfidence);
  }
  return groups;
}

std::vector<std::vector<std::string>> coefficient_table(const FactorModel& model) {
  const auto* logistic = std::get_if<LogisticFit>(&model.fit);
  std::vector<std::vector<std::string>> rows{
      {"term", logistic ? "log odds" : "estimate", "error", "95 % interval", "p"}};
  const auto& coefficients =
      logistic ? logistic->coefficients : std::get<LinearFit>(model.fit).coefficients;
  for (const Coefficient& one : coefficients) {
    const bool endless =
        logistic && std::find(logistic->separated.begin(), logistic->separated.end(), one.name) !=
                        logistic->separated.end();
    std::vector<std::string> row{one.name.empty() ? "(constant)" : files::one_line(one.name)};
    if (endless) {
      // Of a perfect fit, even the signs may be rounding errors.
      row.insert(row.end(), {logistic->perfect    ? "-"
                             : one.estimate > 0.0 ? "\xe2\x88\x9e"
                                                  : "-\xe2\x88\x9e",
                             "-", "-", "-"});
    } else {
      row.insert(row.end(),
                 {brief(one.estimate), brief(one.error, 3),
                  brief(one.interval.low) + " to " + brief(one.interval.high), p_text(one.p)});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string fit_in_words(const FactorModel& model) {
  const auto p = [](double value) {
    return value < 0.001 ? "p " + p_text(value) : "p = " + p_text(value);
  };
  const std::string runs =
      counted(model.runs, model.runs < model.cells.size() ? "different run" : "run");
  if (const auto* fit = std::get_if<LinearFit>(&model.fit)) {
    return runs + "; R\xc2\xb2 " + fixed_text(fit->r_squared, 3) + ", adjusted " +
           fixed_text(fit->adjusted_r_squared, 3) + "; standard deviation of the residuals " +
           brief(fit->deviation, 3) +
           (model.response.unit.empty() ? "" : " " + files::one_line(model.response.unit)) +
           (fit->f ? "; F " + brief(*fit->f, 3) + ", " : "; ") + p(fit->p);
  }
  const auto& fit = std::get<LogisticFit>(model.fit);
  return runs + "; deviance " + brief(fit.deviance) + " with " + std::to_string(fit.freedom) +
         " degrees of freedom, " + brief(fit.null_deviance) + " without the factors; " + p(fit.p);
}

}  // namespace elsie::report
