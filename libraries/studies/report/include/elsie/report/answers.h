// What a user asks beyond the questions of the experiment: levels, comparisons, models.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elsie/report/contrasts.h"
#include "elsie/report/factor_models.h"

namespace elsie::report {

struct Asked {
  std::vector<std::string> by;                                // factors
  std::vector<std::pair<std::string, std::string>> compared;  // groups, as for compare()
  std::vector<std::string> models;                            // formulas, as for factor_model()
};

/// One combination of levels of the factors that were asked for.
struct LevelRow {
  std::vector<std::string> levels;
  std::size_t cells = 0;
  std::vector<Margin> margins;  // parallel to responses()
};

struct Answers {
  std::vector<std::string> by;
  std::vector<LevelRow> levels;
  std::vector<std::string> by_notes;  // what these left out, as sentences without a full stop
  std::vector<std::vector<Contrast>> comparisons;  // corrected over all of a response
  std::vector<FactorModel> models;

  bool none() const { return by.empty() && comparisons.empty() && models.empty(); }
};

/// Throws std::invalid_argument, with a sentence, for what cannot be answered.
Answers answer(const Findings& findings, const Asked& asked);

/// For a terminal, without the rest of the report; "" if nothing was asked. If the results are not
/// good, the last line says why.
std::string terminal_answers(const Findings& findings, const Answers& answers);

}  // namespace elsie::report
