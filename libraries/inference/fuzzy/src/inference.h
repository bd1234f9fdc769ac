// Computes degrees from inputs, and sets and numbers from degrees.
#pragma once

#include <cstddef>
#include <optional>

#include "model_data.h"
#include "workspace.h"

namespace elsie::fuzzy {

/// Computes the degrees of rules and slots from memory.inputs.
void fire_rules(const ModelData& model, Workspace::Memory& memory);

/// The number for an output; none when no rule fires on it.
std::optional<double> defuzzified(const ModelData& model, std::size_t output,
                                  Workspace::Memory& memory);

/// The accumulated set of an output; without points when no rule fires on it.
void accumulated(const ModelData& model, std::size_t output, Workspace::Memory& memory,
                 FuzzySet& set);

}  // namespace elsie::fuzzy
