// Models of a response by the factors of an experiment.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elsie/report/margins.h"
#include "elsie/report/models.h"

namespace elsie::report {

struct FactorModel {
  Response response;
  std::string formula;   // "time_s ~ max_speed + coordinator"
  std::size_t runs = 0;  // different ones
  /// The cell and the weight of each observation: copies of a run share its weight of 1.
  std::vector<std::size_t> cells{};
  std::vector<double> weights{};
  std::variant<LinearFit, LogisticFit> fit{};  // logistic of success
  std::vector<std::string> warnings;           // sentences
};

/// A model with more is refused.
inline constexpr std::size_t kMostCoefficients = 100;

/// The model of a formula: "MEASURE ~ FACTOR + FACTOR:FACTOR"; "a * b" is "a + b + a:b". A factor
/// whose levels are numbers is one term, its distance from its mean; any other factor has a term
/// for each level but the first, of success for each but the first with successes and failures.
/// Each run of the seeds that have a value in each cell counts as an independent observation; a
/// cell whose seeds all gave one and the same run counts once, and runs of several cells that are
/// the same bit by bit count together as one. Throws std::invalid_argument, with a
/// sentence, for a formula that names what is not there, more coefficients than cells, runs of one
/// seed only, equal values, and values that are only bounds.
FactorModel factor_model(const Findings& findings, const std::string& formula);

/// The formula with all factors and no interactions.
std::string main_effects(const Findings& findings, const Response& response);

/// Cells with about the same fitted rate of success.
struct RateGroup {
  double fitted = 0.0;  // mean over the runs
  Frequency observed;
  Interval interval;  // Wilson's, of the observed rate
};

inline constexpr std::size_t kMostRateGroups = 10;

/// Fitted against observed rates of a logistic model, ascending: a group for each fitted rate, or,
/// of more than kMostRateGroups rates, neighbours in groups of about as many runs (Hosmer and
/// Lemeshow 1980). Where an observed rate is far from the fitted one, a term may be missing.
std::vector<RateGroup> rate_groups(const FactorModel& model);

/// The coefficients as texts with a head.
std::vector<std::vector<std::string>> coefficient_table(const FactorModel& model);

/// "R2 0.83, adjusted 0.82; residuals 1.2 m; F 95.2, p < 0.001": the fit as a whole.
std::string fit_in_words(const FactorModel& model);

}  // namespace elsie::report
