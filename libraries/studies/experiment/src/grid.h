// What the cells of an experiment set, and where that stands.
#pragma once

#include <string>
#include <vector>

#include "elsie/experiment/experiment.h"

namespace elsie::experiment {

/// The factor that the worlds are.
inline constexpr const char* kWorldFactor = "world";

/// Where the experiment's time limit is set in each world.
inline constexpr const char* kTimeLimitPath = "limits/@time";

/// What is set in the worlds of a cell, in order.
std::vector<Setting> settings_of(const Experiment& experiment, const Cell& cell);

/// "PATH=VALUE"
std::string override_of(const Setting& setting);

/// Whether a label is as a pattern says, in which a "*" stands for any text.
bool matches(const std::string& pattern, const std::string& label);

/// All labels of a factor ("world": the ids), or an empty list when there is no such factor.
std::vector<std::string> labels_of(const Experiment& experiment, const std::string& factor);

}  // namespace elsie::experiment
