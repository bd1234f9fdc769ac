// What a fuzzy model computes from the inputs of an instant.
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "elsie/fuzzy/model.h"

namespace elsie::desktop {

/// Degrees of the rules, and the accumulated set of each output with its centre of gravity. All are
/// empty while an input is missing.
struct FuzzyInstant {
  std::vector<double> inputs;
  std::vector<double> degrees;
  std::vector<FuzzySet> sets;
  std::vector<std::optional<double>> centres;  // none if the set has no area
  QString problem;                             // why it cannot be computed; "" if it can
};

FuzzyInstant fuzzy_instant(const fuzzy::Model& model, std::vector<double> inputs);

/// An output over two inputs, with the others held; over one input if there is no second.
struct FuzzyGrid {
  static constexpr std::size_t kAcross = 41;
  std::size_t rows = 0;        // 1 if there is no second input
  std::vector<double> values;  // kAcross in a row, from the lowest; NaN where undefined
};

/// `across` and `up` are indices of inputs; `held` has a value for each input.
FuzzyGrid fuzzy_grid(const fuzzy::Model& model, std::size_t output, std::size_t across,
                     std::optional<std::size_t> up, std::vector<double> held);

}  // namespace elsie::desktop
