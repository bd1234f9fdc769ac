// Finds inputs for which no rule decides an output.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "model_data.h"

namespace elsie::fuzzy {

/// A gap of one output.
struct Gap {
  bool certain = true;  // false: neither a gap nor its absence could be shown
  std::string example;  // "range = 0.5, azimuth = 90": no rule fires here (or near here)
};

/// Searches all inputs, within their ranges if they have one, for a place where no rule on the
/// output fires. If it finds none, there is none.
std::optional<Gap> find_gap(const ModelData& model, std::size_t output);

}  // namespace elsie::fuzzy
