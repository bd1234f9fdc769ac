#include "watch/fuzzy_instant.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "elsie/fuzzy/sets.h"

namespace elsie::desktop {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();

double between(const fuzzy::Range& range, std::size_t place) {
  return range.low + (range.high - range.low) * static_cast<double>(place) /
                         static_cast<double>(FuzzyGrid::kAcross - 1);
}

}  // namespace

FuzzyInstant fuzzy_instant(const fuzzy::Model& model, std::vector<double> inputs) {
  FuzzyInstant now;
  if (inputs.size() != model.inputs().size()) {
    return now;
  }
  try {
    fuzzy::Workspace workspace;
    std::vector<double> degrees(model.rules().size());
    model.rule_degrees(inputs, degrees, workspace);
    for (std::size_t i = 0; i < model.outputs().size(); ++i) {
      FuzzySet set = model.output_set(i, inputs, workspace);
      auto centre = fuzzy::centroid(set);
      now.centres.push_back(
          centre ? centre : fuzzy::defuzzify(set, fuzzy::Defuzzification::centroid_of_singletons));
      now.sets.push_back(std::move(set));
    }
    now.degrees = std::move(degrees);
    now.inputs = std::move(inputs);
  } catch (const std::exception& error) {
    now = {};
    now.problem = QString::fromUtf8(error.what());
  }
  return now;
}

FuzzyGrid fuzzy_grid(const fuzzy::Model& model, std::size_t output, std::size_t across,
                     std::optional<std::size_t> up, std::vector<double> held) {
  FuzzyGrid grid;
  grid.rows = up ? FuzzyGrid::kAcross : 1;
  fuzzy::Workspace workspace;
  std::vector<double> outputs(model.outputs().size());
  for (std::size_t row = 0; row < grid.rows; ++row) {
    if (up) {
      held[*up] = between(model.inputs()[*up].range, row);
    }
    for (std::size_t column = 0; column < FuzzyGrid::kAcross; ++column) {
      held[across] = between(model.inputs()[across].range, column);
      outputs.assign(outputs.size(), kNoValue);
      try {
        model.evaluate(held, outputs, workspace);
        grid.values.push_back(outputs[output]);
      } catch (const std::invalid_argument&) {  // a formula has no value there
        grid.values.push_back(kNoValue);
      }
    }
  }
  return grid;
}

}  // namespace elsie::desktop
