// Databases that are valid for a report, but hardly a study.
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
/// missing and infinite values.
std::vector<EdgeCase> edge_cases();

/// The mean of a measure that all edge cases could have, and a success rate.
report::Questions edge_questions();

}  // namespace elsie::test
