// Is there an input for which no rule speaks of an output?
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model_data.h"

namespace elsie::fuzzy {

/// What was found of one output.
struct Gap {
  bool certain = true;  // false: neither a gap nor its absence could be shown
  std::string example;  // "range = 0.5, azimuth = 90": no rule fires here (or near here)
};

/// Looks through all inputs, within their ranges where given and everywhere else, for one at which
/// no rule on the output fires. Sound: when it finds none, there is none.
std::optional<Gap> find_gap(const ModelData& model, std::size_t output);

}  // namespace elsie::fuzzy
