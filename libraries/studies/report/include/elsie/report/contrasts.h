// Cells compared with other cells, over everything else that is varied.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "elsie/report/comparisons.h"
#include "elsie/report/margins.h"

namespace elsie::report {

/// Some cells by a name.
struct Group {
  std::string name;  // "fuzzy fusion", "coordinator=fuzzy fusion"
  std::vector<std::size_t> cells;
};

/// One response in two groups of cells.
struct Contrast {
  Response response;
  std::string first, second;
  Margin of_first, of_second;
  bool equal = false;  // all values of both groups are_equal(), and known
  /// Each cell gave one and the same run for all its seeds: no intervals, and no p-values.
  bool certain = false;
  /// The runs of both groups are the same bit by bit: what tells them apart has no effect.
  bool same = false;
  std::vector<std::string> notes;  // what was left out: see notes_on()

  // All runs of one group that count against all of the other, as if all were independent. A cell
  // whose seeds all gave one and the same run counts once, and so do runs of a group that are the
  // same bit by bit.
  Effect effect;            // the odds ratio of success; Cliff's delta of a measure
  std::optional<Effect> g;  // Hedges'; none for success, with bounds, without spread
  double pooled_p = 1.0;    // of Fisher's test; of the rank test
  bool pooled_exact = true;
  double pooled_holm = 1.0;  // corrected for all contrasts of the response

  // Seed by seed: a seed's difference is the mean of those between cells that match.
  std::size_t seeds = 0;
  std::optional<double> difference;  // the mean; none with bounds
  std::optional<Interval> interval;
  /// The signed-rank test. With bounds, a seed's difference is how much more often one group is
  /// above the other.
  PairTest paired;
  double paired_holm = 1.0;

  bool is_tested() const { return !certain && !same; }
};

/// Of the cells and seeds that balanced() leaves. Cells match if they have the same levels of all
/// factors but `named` (indices into Results::factors). None without a value in one of the groups.
std::optional<Contrast> contrast(const Findings& findings, const Response& response,
                                 const Group& first, const Group& second,
                                 const std::vector<std::size_t>& named);

/// Corrects the p-values of contrasts of one response; those without tests do not count.
void correct(std::vector<Contrast*> contrasts);

/// All pairs of levels of all factors, corrected. Factors with more than kMostLevels levels are
/// left out: their pairs are too many to read.
std::vector<Contrast> level_contrasts(const Findings& findings, const Response& response);

inline constexpr std::size_t kMostLevels = 8;

/// The cells of "coordinator=fusion|arbitration; network=4 4" (a choice as in experiments), or
/// those with this label. `named`: the factors in it are added. Throws std::invalid_argument, with
/// a sentence, for a factor, a level or a label that is not there.
Group group_of(const Findings& findings, const std::string& text, std::vector<std::size_t>& named);

/// All responses of two groups by text. Throws std::invalid_argument, with a sentence, for groups
/// that are not there, have a cell in common, have one seed only, or all equal values.
std::vector<Contrast> compare(const Findings& findings, const std::string& first,
                              const std::string& second);

/// For people: groups, effects, tests, as tables of texts with a head.
std::vector<std::vector<std::string>> contrast_table(const std::vector<Contrast>& contrasts,
                                                     bool with_response);

/// What these contrasts left out, as sentences without a full stop.
std::vector<std::string> contrast_notes(const std::vector<Contrast>& contrasts, bool with_response);

}  // namespace elsie::report
