// Sentences that several forms of the report have in common.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "elsie/report/findings.h"

namespace elsie::report {

/// "160 runs: 8 cells with 20 seeds each"; of a part of an experiment also which.
std::string size_in_words(const Findings& findings);

/// "4 of 6 runs are not in this database"; of one that has a shard also which.
std::string missing_in_words(const Findings& findings);

/// "in 2 of 6 cells all seeds gave one and the same run: nothing there is left to chance (a, b)";
/// "" for none. Names three cells at most.
std::string one_run_in_words(const Findings& findings);

/// "in 3 of 40 runs the solver of the physics gave up in some steps, most often in run 7 (a, seed
/// 3), in 415 of 2000"; "" for none.
std::string give_ups_in_words(const Findings& findings);

/// "3/4", or "no goals".
std::string success_in_words(const CellFindings& cell);

/// "37 of 40", of the runs that ended in cells with goals; "no goals" when there are none.
std::string successes_in_words(const Findings& findings);

/// A sample with bounds among its values: "> 40.00" when there are only bounds, "median 31.33, 1 of
/// 4 > 40.00" when the median is known, "3 of 4 > 40.00" when it is not.
std::string censored_in_words(const MeasureFindings& found, std::optional<int> decimals);

/// How many decimals a measure (a place in Findings::measures) has in a table of all cells: what
/// the cell with the finest spread asks for, but at most three more than the coarsest one. None:
/// its values are better written with exponents.
std::optional<int> decimals_of(const Findings& findings, std::size_t measure);

/// How a run ended that did not end by itself: "crash: plugin 'x' of robot 'r1' crashed with
/// SIGSEGV in step 812". That is its message; signal, plugin, robot and step stand before it where
/// it does not tell them: "crash by SIGKILL in plugin 'x': ...". What is not known is left out.
std::string ending_in_words(const Run& run);

/// "all 6 runs crashed, the first of them run 1 (fusion, seed 3)", "2 of 6 runs did not end by
/// themselves (1 crashed, 1 hung), the first of them ..."; "" when every run that ended did so by
/// itself.
std::string broken_in_words(const Findings& findings);

/// The same as ending_in_words() without the first word.
std::string circumstances(const Run& run);

/// "run 17 (fusion, seed 3)"
std::string name_of(const Results& results, const Run& run);

/// "runs 17 and 18 (fusion, seed 3) ended in different states"
std::string in_words(const Results& results, const Disagreement& disagreement);

}  // namespace elsie::report
