// Choices of cells or runs by their levels: "coordinator=fusion|arbitration; layers=2 2".
#pragma once

#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::experiment {

/// What a choice may name: a factor, and all its labels.
struct Labels {
  std::string factor;
  std::vector<std::string> labels;
};

/// Of an experiment: first the worlds, then the factors in order.
std::vector<Labels> labels_of(const Experiment& experiment);

/// Reads FACTOR=LEVEL|LEVEL; FACTOR=LEVEL, with "*" for any text in a level; all of these must
/// match. Throws std::invalid_argument with a sentence that names the nearest factor or level.
std::vector<Where> parse_where(const std::string& text, const std::vector<Labels>& known);

}  // namespace elsie::experiment
