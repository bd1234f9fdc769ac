// Turns the file's elements into expectations, which are statements about cells.
#pragma once

#include <vector>

#include "elsie/base/problems.h"
#include "elsie/experiment/experiment.h"

#include "draft.h"

namespace elsie::experiment {

/// The experiment must already have its worlds and factors. Leaves out expectations with problems.
std::vector<Expectation> expectations_from(const std::vector<ExpectationDraft>& drafts,
                                           const Experiment& experiment, base::Problems& problems);

/// An expectation in words: "rate of success, coordinator=fusion: at least 1".
std::string in_words(const Expectation& expectation);

}  // namespace elsie::experiment
