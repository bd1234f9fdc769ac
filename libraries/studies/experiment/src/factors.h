// Factors, levels and settings: from what a file says to what is set.
#pragma once

#include <string>
#include <vector>

#include "elsie/base/problems.h"
#include "elsie/experiment/experiment.h"

#include "draft.h"

namespace elsie::experiment {

/// The text without the blanks around it.
std::string trimmed(const std::string& text);

/// Its parts, between the separators; blanks around them do not count.
std::vector<std::string> split(const std::string& text, char separator);

/// Why a text cannot be a label, for the end of a sentence: "a label may not be empty"; "" when it
/// can.
std::string why_no_label(const std::string& text);

/// For the end of a sentence about the only level of values="...", when it looks like several:
/// "; the levels of values are separated by ';'"; otherwise "".
std::string how_to_separate(const Factor& factor);

/// The settings that make sense; the others become problems.
std::vector<Setting> settings_from(const std::vector<SettingDraft>& drafts,
                                   base::Problems& problems);

/// The same for factors: those with problems have no levels.
std::vector<Factor> factors_from(const std::vector<FactorDraft>& drafts, base::Problems& problems);

/// The numbers of a range as texts with as few digits as they take: 0.1 to 0.3 in steps of 0.1 are
/// "0.1", "0.2", "0.3". Throws std::invalid_argument with a sentence.
std::vector<std::string> range(double from, double to, double step);

}  // namespace elsie::experiment
