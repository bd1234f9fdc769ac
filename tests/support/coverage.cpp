#include "coverage.h"

#include <cmath>
#include <functional>
#include <stdexcept>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/random.h"
#include "elsie/report/comparisons.h"
#include "elsie/report/models.h"
#include "elsie/report/survival.h"

namespace elsie::test {

namespace {

using namespace report;

constexpr double kLevel = 0.95;
constexpr std::uint64_t kStream = 7;

// Whether the interval of one simulated sample holds the truth; none: there is no interval.
using Trial = std::function<std::optional<bool>(Random&, std::size_t)>;

bool holds(const Interval& interval, double truth) {
  return interval.low <= truth && truth <= interval.high;
}

std::optional<bool> held(const std::optional<Interval>& interval, double truth) {
  return interval ? std::optional(holds(*interval, truth)) : std::nullopt;
}

CoverageRow simulated(const std::string& interval, const std::string& drawn, int experiments,
                      const Trial& trial) {
  CoverageRow row{interval, drawn, {}};
  for (const std::size_t size : kSeedsOfCoverage) {
    int count = 0, hits = 0;
    for (int i = 0; i < experiments; ++i) {
      Random random(static_cast<std::uint64_t>(i), interval + drawn + std::to_string(size));
      if (const auto one = trial(random, size)) {
        ++count;
        hits += *one ? 1 : 0;
      }
    }
    row.held.push_back(count > 0 ? std::optional(double(hits) / count) : std::nullopt);
  }
  return row;
}

struct Distribution {
  const char* name;
  double mean;
  double median;
  std::function<double(Random&)> draw;
};

std::vector<Distribution> distributions() {
  return {{"normal", 10.0, 10.0, [](Random& random) { return random.normal(10.0, 2.0); }},
          {"uniform", 0.5, 0.5, [](Random& random) { return random.uniform(); }},
          {"log-normal (σ 0.5)", std::exp(0.125), 1.0,
           [](Random& random) { return std::exp(random.normal(0.0, 0.5)); }},
          {"log-normal (σ 1)", std::exp(0.5), 1.0,
           [](Random& random) { return std::exp(random.normal(0.0, 1.0)); }}};
}

std::vector<double> sample(const Distribution& of, Random& random, std::size_t size) {
  std::vector<double> values(size);
  for (double& value : values) value = of.draw(random);
  return values;
}

Interval student(const std::vector<double>& values) {
  const auto all = summary(values);
  const auto count = static_cast<double>(values.size());
  const double reach =
      boost::math::quantile(boost::math::students_t(count - 1.0), 0.5 + 0.5 * kLevel) *
      *all->standard_deviation / std::sqrt(count);
  return {all->mean - reach, all->mean + reach};
}

void add_means(int experiments, std::vector<CoverageRow>& rows) {
  for (const Distribution& of : distributions()) {
    rows.push_back(simulated(
        "mean: **bootstrap-t**", of.name, experiments, [&](Random& random, std::size_t size) {
          return held(mean_interval(sample(of, random, size), kLevel, kStream, "coverage"),
                      of.mean);
        }));
    rows.push_back(
        simulated("mean: Student's t", of.name, experiments, [&](Random& random, std::size_t size) {
          return held(student(sample(of, random, size)), of.mean);
        }));
    rows.push_back(simulated(
        "mean: percentile bootstrap", of.name, experiments, [&](Random& random, std::size_t size) {
          return held(bootstrap_interval(Statistic::mean, sample(of, random, size), kLevel, kStream,
                                         "coverage"),
                      of.mean);
        }));
  }
  for (const Distribution& of : distributions()) {
    rows.push_back(simulated(
        "median: order statistics", of.name, experiments, [&](Random& random, std::size_t size) {
          return held(median_interval(sample(of, random, size), kLevel), of.median);
        }));
  }
}

std::vector<Pair> pairs_of(Random& random, std::size_t size) {
  std::vector<Pair> pairs(size);
  for (Pair& pair : pairs) {
    const double seed = random.normal(20.0, 4.0);
    pair = {2.0 * seed + 3.0 + random.normal(0.0, 1.0), seed};
  }
  return pairs;
}

void add_pairs(int experiments, std::vector<CoverageRow>& rows) {
  const auto add = [&](const char* name, Relation relation, double truth) {
    rows.push_back(simulated(name, "normal, with effects of the seed", experiments,
                             [=](Random& random, std::size_t size) {
                               return held(paired_interval(relation, Statistic::mean,
                                                           pairs_of(random, size), kLevel, kStream,
                                                           "coverage"),
                                           truth);
                             }));
  };
  add("difference of means: **bootstrap-t** of pairs", Relation::difference, 23.0);
  add("ratio of means: **bootstrap-t** of pairs", Relation::ratio, 2.15);
}

Frequency frequency(Random& random, std::size_t size, double p) {
  Frequency of{0, size};
  for (std::size_t i = 0; i < size; ++i) of.hits += random.chance(p) ? 1 : 0;
  return of;
}

void add_rates(int experiments, std::vector<CoverageRow>& rows) {
  for (const double p : {0.5, 0.8, 0.95}) {
    rows.push_back(
        simulated("rate: **Wilson**", "probability " + base::number_text(p), experiments,
                  [=](Random& random, std::size_t size) {
                    return std::optional(
                        holds(wilson_interval(frequency(random, size, p).hits, size, kLevel), p));
                  }));
  }
  const std::string both = "probabilities 0.8 and 0.5";
  rows.push_back(simulated(
      "difference of rates: **Newcombe**", both, experiments, [](Random& random, std::size_t size) {
        const Frequency a = frequency(random, size, 0.8);
        return held(
            interval_of_rates(Relation::difference, a, frequency(random, size, 0.5), kLevel), 0.3);
      }));
  rows.push_back(
      simulated("odds ratio: **Woolf**", both, experiments, [](Random& random, std::size_t size) {
        const Frequency a = frequency(random, size, 0.8);
        return held(odds_ratio(a, frequency(random, size, 0.5), kLevel).interval, 4.0);
      }));
  rows.push_back(simulated("log odds of a logistic model: **Wald**", both, experiments,
                           [](Random& random, std::size_t size) -> std::optional<bool> {
                             Term second{"second", {}};
                             std::vector<bool> successes;
                             for (std::size_t i = 0; i < 2 * size; ++i) {
                               second.values.push_back(i < size ? 0.0 : 1.0);
                               successes.push_back(random.chance(i < size ? 0.5 : 0.8));
                             }
                             const std::vector<Term> terms{second};
                             try {
                               const LogisticFit fit = fit_logistic(terms, successes, kLevel);
                               return fit.separated.empty()
                                          ? std::optional(
                                                holds(fit.coefficients[1].interval, std::log(4.0)))
                                          : std::nullopt;
                             } catch (const std::invalid_argument&) {
                               return std::nullopt;
                             }
                           }));
}

void add_survival(int experiments, std::vector<CoverageRow>& rows) {
  // Exponential times with mean 50; the limit cuts off three of ten.
  const double limit = -50.0 * std::log(0.3), median = 50.0 * std::log(2.0);
  const auto curve_of = [=](Random& random, std::size_t size) {
    std::vector<Observed> times(size);
    for (Observed& one : times) {
      const double time = -50.0 * std::log(1.0 - random.uniform());
      one = {std::min(time, limit), time > limit};
    }
    return survival_of(times, kLevel);
  };
  const std::string drawn = "exponential, 30 % cut off";
  rows.push_back(simulated("median of cut-off times: **Brookmeyer-Crowley**", drawn, experiments,
                           [=](Random& random, std::size_t size) {
                             return held(curve_of(random, size).median_interval, median);
                           }));
  rows.push_back(simulated("point of the curve: **Greenwood, log(-log)**", drawn, experiments,
                           [=](Random& random, std::size_t size) -> std::optional<bool> {
                             Interval at{1.0, 1.0};
                             for (const SurvivalStep& step : curve_of(random, size).steps) {
                               if (step.time <= median) at = step.interval;
                             }
                             return at.low < at.high ? std::optional(holds(at, 0.5)) : std::nullopt;
                           }));
}

void add_effects(int experiments, std::vector<CoverageRow>& rows) {
  const auto groups = [](Random& random, std::size_t size) {
    std::pair<std::vector<double>, std::vector<double>> both;
    for (std::size_t i = 0; i < size; ++i) {
      both.first.push_back(random.normal(1.0, 1.0));
      both.second.push_back(random.normal(0.0, 1.0));
    }
    return both;
  };
  const std::string drawn = "normal, one deviation apart";
  rows.push_back(simulated(
      "Cliff's delta: **Cliff**", drawn, experiments, [=](Random& random, std::size_t size) {
        const auto [a, b] = groups(random, size);
        std::vector<Observed> first, second;
        for (const double value : a) first.push_back({value, false});
        for (const double value : b) second.push_back({value, false});
        // 2 P(a > b) - 1, where a - b has the deviation of two.
        return held(rank_test(first, second, kLevel).delta.interval, std::erf(0.5));
      }));
  rows.push_back(
      simulated("Hedges' g: **normal**", drawn, experiments, [=](Random& random, std::size_t size) {
        const auto [a, b] = groups(random, size);
        return held(hedges_g(a, b, kLevel)->interval, 1.0);
      }));
  rows.push_back(simulated("slope of a linear model: **Student's t**", "three levels, normal",
                           experiments, [](Random& random, std::size_t size) {
                             Term x{"x", {}};
                             std::vector<double> y;
                             for (std::size_t i = 0; i < 3 * size; ++i) {
                               x.values.push_back(static_cast<double>(i % 3));
                               y.push_back(2.0 * x.values.back() + random.normal(0.0, 1.0));
                             }
                             const std::vector<Term> terms{x};
                             return std::optional(
                                 holds(fit_linear(terms, y, kLevel).coefficients[1].interval, 2.0));
                           }));
}

}  // namespace

std::vector<CoverageRow> simulate_coverage(int experiments) {
  std::vector<CoverageRow> rows;
  add_means(experiments, rows);
  add_pairs(experiments, rows);
  add_rates(experiments, rows);
  add_survival(experiments, rows);
  add_effects(experiments, rows);
  return rows;
}

std::string coverage_table(const std::vector<CoverageRow>& rows) {
  std::string text = "| interval | drawn from |";
  std::string rule = "|---|---|";
  for (const std::size_t size : kSeedsOfCoverage) {
    text += " " + std::to_string(size) + " seeds |";
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const CoverageRow& row : rows) {
    text += "| " + row.interval + " | " + row.drawn + " |";
    for (const auto& part : row.held) {
      text += part ? " " + base::fixed_text(100.0 * *part, 1) + " |" : " - |";
    }
    text += "\n";
  }
  return text;
}

}  // namespace elsie::test
