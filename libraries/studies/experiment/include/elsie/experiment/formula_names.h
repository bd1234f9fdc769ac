// Names in the formulas of measures, besides measures.
#pragma once

#include <optional>
#include <string>

namespace elsie::experiment {

/// Whether a formula may use this name whatever is measured: `robots`, those of the run at its end,
/// and `minute` or `minutes`, the simulated time of the run by 60 s.
bool is_of_every_run(const std::string& name);

/// The number that a label is: "0.25"; none for any other text.
std::optional<double> number_in(const std::string& label);

}  // namespace elsie::experiment
