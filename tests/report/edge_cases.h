// Databases that a report may well be asked for, but that are not a study as one has it in mind.
#pragma once

#include <string>
#include <vector>

#include "fixture.h"

namespace elsie::test {

struct EdgeCase {
  std::string name;
  MadeExperiment experiment;
};

/// All runs crashed; none is done; one run; one cell; a hundred cells; bad names; long names;
/// values that are not there or not finite.
std::vector<EdgeCase> edge_cases();

/// A mean of a measure that the runs of all edge cases would have, and a rate of success.
report::Questions edge_questions();

}  // namespace elsie::test
