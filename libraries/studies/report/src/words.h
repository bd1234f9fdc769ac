// Sentences that several forms of the report use.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "elsie/report/findings.h"

namespace elsie::report {

/// "160 runs: 8 cells with 20 seeds each"; for a part of an experiment, with the shard.
/// Of a batch that has not ended, "5 of 20 seeds complete": ended in every cell.
std::string size_in_words(const Findings& findings);

/// "4 of 6 runs are not in this database"; for a shard, with its number.
std::string missing_in_words(const Findings& findings);

/// "All 3 expectations are met", "1 of 3 expectations is not met": the answer in a line.
std::string answer_in_words(const Findings& findings);

/// "in 2 of 6 cells all seeds gave one and the same run: nothing there is random (a, b)";
/// "" if there are none. Names at most three cells.
std::string one_run_in_words(const Findings& findings);

/// "in 3 of 40 runs the solver of the physics gave up in some steps, most often in run 7 (a, seed
/// 3), in 415 of 2000"; "" for none.
std::string give_ups_in_words(const Findings& findings);

/// A label of a cell on one line, with at most `most` characters. If it is too long, each level is
/// shortened to its share, because levels after a long one may be all that differs between cells.
std::string short_label(const std::string& label, std::size_t most);

/// "3/4", or "no goals".
std::string success_in_words(const CellFindings& cell);

/// "37 of 40" ended runs in cells with goals; "no goals" if no cell has any.
std::string successes_in_words(const Findings& findings);

/// A sample with bounds: "> 40.00" if all values are bounds, "median 31.33, 1 of 4 > 40.00" if the
/// median is known, "3 of 4 > 40.00" if it is not.
std::string censored_in_words(const MeasureFindings& found, std::optional<int> decimals);

/// The decimals of a measure (an index into Findings::measures) in a table of all cells: as many as
/// the cell with the smallest spread needs, but at most three more than that with the largest. None
/// if its values need exponents.
std::optional<int> decimals_of(const Findings& findings, std::size_t measure);

/// How a failed run ended: "crash: plugin 'x' of robot 'r1' crashed with SIGSEGV in step 812".
/// Signal, plugin, robot and step come before the message if it does not name them: "crash by
/// SIGKILL in plugin 'x': ...". Unknown parts are left out.
std::string ending_in_words(const Run& run);

/// "all 6 runs crashed, the first of them run 1 (fusion, seed 3)", "2 of 6 runs ended abnormally
/// (1 crashed, 1 hung), the first of them ..."; "" if no run failed.
std::string broken_in_words(const Findings& findings);

/// As ending_in_words(), but without the first word.
std::string circumstances(const Run& run);

/// "run 17, seed 3"
std::string name_of(const Run& run);

/// "success", "time limit", "crash"...
std::string outcome_in_words(const Run& run);

/// "run 17 (fusion, seed 3)"
std::string name_of(const Results& results, const Run& run);

/// "runs 17 and 18 (fusion, seed 3) ended in different states"
std::string in_words(const Results& results, const Disagreement& disagreement);

}  // namespace elsie::report
