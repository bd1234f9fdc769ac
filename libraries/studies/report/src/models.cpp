#include "elsie/report/models.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Dense>

#include "elsie/base/words.h"

#include "distributions.h"

namespace elsie::report {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDependent = 1e-9;  // the part of a column that must be new
constexpr double kRounding = 1e-12;  // of an estimate, in standard errors

struct Design {
  MatrixXd columns;  // the constant first
  std::vector<std::string> names;
  std::vector<std::string> left_out;
};

// Keeps columns that are not combinations of earlier ones (Gram and Schmidt, twice for accuracy).
Design design_of(std::span<const Term> terms, std::size_t rows) {
  Design design;
  std::vector<VectorXd> kept, basis;
  const auto add = [&](const std::string& name, const VectorXd& column) {
    VectorXd rest = column;
    for (int pass = 0; pass < 2; ++pass) {
      for (const VectorXd& direction : basis) {
        rest -= direction.dot(rest) * direction;
      }
    }
    if (rest.norm() <= kDependent * column.norm()) {
      design.left_out.push_back(name);
      return;
    }
    basis.push_back(rest.normalized());
    kept.push_back(column);
    design.names.push_back(name);
  };
  add("", VectorXd::Ones(static_cast<Eigen::Index>(rows)));
  for (const Term& term : terms) {
    add(term.name, Eigen::Map<const VectorXd>(term.values.data(), std::ssize(term.values)));
  }
  design.columns.resize(static_cast<Eigen::Index>(rows), std::ssize(kept));
  for (Eigen::Index i = 0; i < std::ssize(kept); ++i) {
    design.columns.col(i) = kept[static_cast<std::size_t>(i)];
  }
  return design;
}

// The weights as a vector, 1 for each row if there are none.
VectorXd weights_of(std::span<const double> weights, Eigen::Index rows) {
  return weights.empty() ? VectorXd::Ones(rows)
                         : VectorXd(Eigen::Map<const VectorXd>(weights.data(), rows));
}

void require_observations(const Design& design, std::size_t rows) {
  const auto terms = static_cast<std::size_t>(design.columns.cols());
  if (rows <= terms) {
    throw std::invalid_argument("a model with " + base::counted(terms, "coefficient") +
                                " needs more observations than that, and there are " +
                                std::to_string(rows) + "; name fewer terms or do more runs");
  }
}

// The inverse of X'X, from the triangle of X = QR.
MatrixXd inverse_square(const Eigen::HouseholderQR<MatrixXd>& qr, Eigen::Index size) {
  const MatrixXd triangle = qr.matrixQR().topLeftCorner(size, size);
  const MatrixXd inverse =
      triangle.triangularView<Eigen::Upper>().solve(MatrixXd::Identity(size, size));
  return inverse * inverse.transpose();
}

// The inflation of a coefficient: its variance relative to that of its column alone.
std::optional<double> inflation_of(const Design& design, const VectorXd& weights,
                                   const MatrixXd& inverse, Eigen::Index index) {
  if (index == 0) {
    return std::nullopt;
  }
  const VectorXd column = design.columns.col(index);
  const double mean = weights.dot(column) / weights.sum();
  return inverse(index, index) * weights.dot((column.array() - mean).square().matrix());
}

}  // namespace

LinearFit fit_linear(std::span<const Term> terms, std::span<const double> values, double confidence,
                     std::span<const double> weights) {
  const Design design = design_of(terms, values.size());
  const VectorXd w = weights_of(weights, std::ssize(values)), roots = w.cwiseSqrt();
  const auto observations = static_cast<std::size_t>(std::lround(w.sum()));
  require_observations(design, observations);
  const VectorXd y = Eigen::Map<const VectorXd>(values.data(), std::ssize(values));
  const double mean = w.dot(y) / w.sum();
  const double all = w.dot((y.array() - mean).square().matrix());
  if (are_equal(y.minCoeff(), y.maxCoeff())) {
    throw std::invalid_argument(
        "all " + std::to_string(values.size()) +
        " values are equal, up to rounding, so there is nothing that a model could "
        "explain; choose a measure that varies");
  }
  const Eigen::Index size = design.columns.cols();
  const Eigen::HouseholderQR<MatrixXd> qr(roots.asDiagonal() * design.columns);
  const VectorXd found = qr.solve(roots.cwiseProduct(y));
  const VectorXd fitted = design.columns * found;
  const VectorXd residuals = y - fitted;
  const double rest = w.dot(residuals.cwiseAbs2());

  LinearFit fit;
  fit.left_out = design.left_out;
  fit.fitted.assign(fitted.begin(), fitted.end());
  fit.residuals.assign(residuals.begin(), residuals.end());
  fit.freedom = observations - static_cast<std::size_t>(size);
  const auto freedom = static_cast<double>(fit.freedom);
  const auto count = static_cast<double>(observations);
  fit.r_squared = 1.0 - rest / all;
  fit.adjusted_r_squared = 1.0 - (rest / freedom) / (all / (count - 1.0));
  fit.deviation = std::sqrt(rest / freedom);
  const bool perfect = rest <= 1e-20 * all;
  if (size > 1 && !perfect) {
    const double explained = static_cast<double>(size - 1);
    fit.f = (all - rest) / explained / (rest / freedom);
    fit.p = fisher_above(std::max(0.0, *fit.f), explained, freedom);
  } else if (perfect) {
    fit.p = 0.0;
  }
  const MatrixXd inverse = inverse_square(qr, size);
  const double reach = student_quantile(0.5 + 0.5 * confidence, freedom);
  for (Eigen::Index i = 0; i < size; ++i) {
    Coefficient one;
    one.name = design.names[static_cast<std::size_t>(i)];
    one.error = fit.deviation * std::sqrt(inverse(i, i));
    one.estimate = std::abs(found(i)) <= kRounding * one.error ? 0.0 : found(i);
    one.interval = {one.estimate - reach * one.error, one.estimate + reach * one.error};
    one.p = perfect ? 0.0 : student_two_sided(one.estimate / one.error, freedom);
    one.inflation = inflation_of(design, w, inverse, i);
    fit.coefficients.push_back(std::move(one));
  }
  return fit;
}

LogisticFit fit_logistic(std::span<const Term> terms, const std::vector<bool>& successes,
                         double confidence, std::span<const double> weights) {
  const Design design = design_of(terms, successes.size());
  const VectorXd w = weights_of(weights, std::ssize(successes)), shares = w.cwiseSqrt();
  const auto observations = static_cast<std::size_t>(std::lround(w.sum()));
  require_observations(design, observations);
  const auto rows = std::ssize(successes);
  VectorXd y(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    y(i) = successes[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
  }
  if (y.sum() == 0.0 || y.sum() == static_cast<double>(rows)) {
    throw std::invalid_argument("all " + std::to_string(rows) + " runs " +
                                (y.sum() > 0.0 ? "succeeded" : "failed") +
                                ", so there is nothing that a model could explain");
  }
  const Eigen::Index size = design.columns.cols();
  const auto deviance_of = [&](const VectorXd& p) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < rows; ++i) {
      const double right = y(i) > 0.5 ? p(i) : 1.0 - p(i);
      sum -= 2.0 * w(i) * std::log(std::max(right, std::numeric_limits<double>::min()));
    }
    return sum;
  };
  // Most fits converge in ten steps. Separated coefficients grow by about 1 per step; one still
  // moving after 25 diverges.
  constexpr int kSteps = 25;
  constexpr double kMoves = 0.1;
  // So does one whose standard error, times its term's largest value, is this many log odds.
  constexpr double kHugeError = 100.0;
  // Where the fit has no error, all coefficients diverge.
  constexpr double kPerfect = 1e-6;
  VectorXd found = VectorXd::Zero(size), step = VectorXd::Zero(size), p;
  MatrixXd inverse;
  for (int i = 0; i < kSteps; ++i) {
    const VectorXd line = design.columns * found;
    p = (1.0 + (-line.array()).exp()).inverse().matrix();
    const VectorXd roots = (p.array() * (1.0 - p.array())).max(1e-14).sqrt().matrix();
    const MatrixXd weighted = roots.cwiseProduct(shares).asDiagonal() * design.columns;
    const VectorXd off = (shares.array() * (y - p).array() / roots.array()).matrix();
    const Eigen::HouseholderQR<MatrixXd> qr(weighted);
    step = qr.solve(off);
    inverse = inverse_square(qr, size);
    found += step;
    if (step.norm() <= 1e-10 * (1.0 + found.norm())) {
      break;
    }
  }
  p = (1.0 + (-(design.columns * found).array()).exp()).inverse().matrix();

  LogisticFit fit;
  fit.left_out = design.left_out;
  fit.fitted.assign(p.begin(), p.end());
  const VectorXd residuals = y - p;
  fit.residuals.assign(residuals.begin(), residuals.end());
  fit.deviance = deviance_of(p);
  fit.null_deviance = deviance_of(VectorXd::Constant(rows, w.dot(y) / w.sum()));
  fit.freedom = observations - static_cast<std::size_t>(size);
  if (size > 1) {
    fit.p = chi_squared_above(std::max(0.0, fit.null_deviance - fit.deviance),
                              static_cast<double>(size - 1));
  }
  fit.perfect = fit.deviance <= kPerfect * fit.null_deviance;
  const double reach = normal_reach(confidence);
  const Eigen::HouseholderQR<MatrixXd> plain(shares.asDiagonal() * design.columns);
  const MatrixXd unweighted = inverse_square(plain, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    Coefficient one;
    one.name = design.names[static_cast<std::size_t>(i)];
    one.error = std::sqrt(inverse(i, i));
    one.estimate = std::abs(found(i)) <= kRounding * one.error ? 0.0 : found(i);
    one.interval = {one.estimate - reach * one.error, one.estimate + reach * one.error};
    one.p = normal_two_sided(one.estimate / one.error);
    one.inflation = inflation_of(design, w, unweighted, i);
    const double largest = design.columns.col(i).cwiseAbs().maxCoeff();
    if (fit.perfect || std::abs(step(i)) * largest > kMoves || one.error * largest > kHugeError) {
      fit.separated.push_back(one.name);
    }
    fit.coefficients.push_back(std::move(one));
  }
  return fit;
}

}  // namespace elsie::report
