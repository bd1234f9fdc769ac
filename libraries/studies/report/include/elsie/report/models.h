// Least squares and logistic regression, with warnings about them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/report/statistics.h"

namespace elsie::report {

/// A column of a model: its value in each observation.
struct Term {
  std::string name;
  std::vector<double> values;
};

struct Coefficient {
  std::string name;  // "" for the constant, which is first
  double estimate = 0.0;
  double error = 0.0;  // standard error
  double p = 1.0;      // of a coefficient of 0, two-sided
  Interval interval;
  /// How much collinearity enlarges the variance (Marquardt 1970); none for the constant.
  std::optional<double> inflation;
};

/// The inflation from which collinearity is worth a word.
inline constexpr double kMuchInflation = 10.0;

struct LinearFit {
  std::vector<Coefficient> coefficients;  // of the terms that were not left out
  /// Terms that are sums of multiples of earlier ones: their effects cannot be told apart.
  std::vector<std::string> left_out;
  std::vector<double> fitted;
  std::vector<double> residuals;
  double r_squared = 0.0;
  double adjusted_r_squared = 0.0;
  double deviation = 0.0;   // of the residuals
  std::size_t freedom = 0;  // observations less coefficients
  std::optional<double> f;  // of all terms together; none without spread of the residuals
  double p = 1.0;
};

/// Least squares of the constant and the terms. Statistics of Student and Fisher; the observations
/// count as independent, and their spread as equal. `weights`: how much each observation counts,
/// above 0, the sum is their number; empty: 1 for each. Throws std::invalid_argument, with a
/// sentence, unless there are more observations than coefficients, and the values differ.
LinearFit fit_linear(std::span<const Term> terms, std::span<const double> values, double confidence,
                     std::span<const double> weights = {});

struct LogisticFit {
  std::vector<Coefficient> coefficients;  // of the logarithm of the odds; Wald's statistics
  std::vector<std::string> left_out;
  /// Coefficients that grow without limit, because a combination of these terms separates the
  /// successes from the others (Albert and Anderson 1984). Their estimates mean nothing.
  std::vector<std::string> separated;
  bool perfect = false;           // the deviance is 0: all coefficients are separated
  std::vector<double> fitted;     // probabilities
  std::vector<double> residuals;  // observed (1: success, 0: any other) minus fitted
  double deviance = 0.0;
  double null_deviance = 0.0;  // of the constant alone
  std::size_t freedom = 0;
  double p = 1.0;  // of all terms together: the difference of deviances
};

/// The most probable coefficients, by iterated weighted least squares. `weights` and
/// errors as of fit_linear().
LogisticFit fit_logistic(std::span<const Term> terms, const std::vector<bool>& successes,
                         double confidence, std::span<const double> weights = {});

}  // namespace elsie::report
