// Turns the file's elements into factors, levels and settings.
#pragma once

#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/experiment/experiment.h"

#include "draft.h"

namespace elsie::experiment {

/// Returns the reason why a text cannot be a label, as the end of a sentence, such as "a label may
/// not be empty"; "" if it can.
std::string why_no_label(const std::string& text);

/// The end of a sentence about the only level of values="..." if it looks like several: "; the
/// levels of values are separated by ';'"; otherwise "".
std::string how_to_separate(const Factor& factor);

/// Returns the valid settings, those made during a run last; the others become problems.
std::vector<Setting> settings_from(const std::vector<SettingDraft>& drafts,
                                   const std::vector<AtDraft>& changes, base::Problems& problems);

/// The same for factors; a factor with problems has no levels.
std::vector<Factor> factors_from(const std::vector<FactorDraft>& drafts, base::Problems& problems);

/// Returns the numbers of a range in as few digits as possible: 0.1 to 0.3 in steps of 0.1 are
/// "0.1", "0.2", "0.3". Throws std::invalid_argument with a sentence.
std::vector<std::string> range(double from, double to, double step);

}  // namespace elsie::experiment
