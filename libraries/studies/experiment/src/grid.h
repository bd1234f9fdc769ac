// The settings of an experiment's cells, and their lines.
#pragma once

#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::experiment {

/// The name of the worlds' factor.
inline constexpr const char* kWorldFactor = "world";

/// The path of the experiment's time limit in each world.
inline constexpr const char* kTimeLimitPath = "limits/@time";

/// The settings of a cell, in order.
std::vector<Setting> settings_of(const Experiment& experiment, const Cell& cell);

/// "PATH=VALUE"
std::string override_of(const Setting& setting);

/// Returns whether a label matches a pattern, in which "*" stands for any text.
bool matches(const std::string& pattern, const std::string& label);

}  // namespace elsie::experiment
