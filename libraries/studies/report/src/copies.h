// Runs that are the same bit by bit: where a factor has no effect on a run, its levels repeat it.
//
// Copies are one observation, however many cells they are in. As independent ones, they would make
// every interval too narrow and every p-value too small, by as much as there are levels without
// effect.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/report/factors.h"

namespace elsie::report {

/// The first of each set of copies, in order. A copy has the same original and the same value.
std::vector<Observation> without_copies(const std::vector<Observation>& all);

/// The weight of each observation in a model: 1 / k if there are k copies of it, itself included.
std::vector<double> shares_of(const std::vector<Observation>& all);

/// The number of independent observations whose mean is as uncertain as that of these, in which
/// each of k copies has the same error: n^2 / sum of k^2 over the different runs (Kish 1965). The
/// number of different runs if all have as many copies.
double effective_count(const std::vector<Observation>& all);

/// How often the levels of a factor gave the same run. A case is a seed with levels of all other
/// factors, for which runs of several levels are done.
struct Copies {
  std::string factor;
  std::size_t cases = 0;
  std::size_t all_same = 0;   // of the cases, those in which all levels gave the same run
  std::size_t some_same = 0;  // those in which some did
};

/// Of all varied factors.
std::vector<Copies> copies_by_factor(const Findings& findings);

/// The number of runs of the cells' samples that repeat an earlier one.
std::size_t count_copies(const Findings& findings);

/// "24 of 36 runs are the same as another, bit by bit: 'noise' had no effect on any run; each
/// counts once in tests, models and intervals"; "" if there are none.
std::string copies_in_words(const Findings& findings);

}  // namespace elsie::report
