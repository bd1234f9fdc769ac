// The common part of judging single cells and pairs of cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/experiment/grid.h"
#include "elsie/report/findings.h"

namespace elsie::report {

// The measures of an expectation as indices into Results::measures; kSuccess has no index.
struct Subject {
  std::optional<std::size_t> measure, per;
  std::string words;
  std::string unit;  // of the statistic
};

// An expectation with the results by which it is judged.
struct Judging {
  const experiment::Expectation& expectation;
  const Findings& findings;
  const Subject& subject;
  const Results& results = findings.results;

  // Returns whether a value, or all values of an interval, are within the limits.
  bool keeps(double value) const;
  bool keeps(const std::optional<Interval>& interval) const;

  // Returns whether it is about success, which has no meaning in a world without goals.
  bool asks_for_success() const;

  // The value of one run; none if it has no value.
  std::optional<double> value_of(const Run& run) const;

  // `infinite`: values that are only known to be larger than a limit count as infinite.
  std::vector<double> values_of(std::size_t cell, bool infinite = false) const;

  // The number of values that are only lower bounds, from runs that never reached their goals.
  std::size_t censored(std::size_t cell) const;
  // Those with this outcome.
  std::size_t censored(std::size_t cell, Outcome outcome) const;

  // The same draws for all cells: equal values have equal intervals.
  const std::string& stream() const { return expectation.name; }

  std::string label(std::size_t cell) const { return results.cells[cell].label; }

  // "at least 0.9, with 95 % confidence"
  std::string limits() const;

  // As few digits as possible, but enough to distinguish the value from the limit.
  std::string shown(double value) const;
  std::string with_unit(double value) const;

  // "19 of 20", "20 runs"
  std::string basis(const std::vector<double>& values) const;

  // Reservations about the values of a cell: "; 2 runs ended abnormally".
  std::string reservations(std::size_t cell) const;

  // "; 95 % interval from 2 to 3"; "" without a confidence.
  std::string interval_in_words(const std::optional<Interval>& interval) const;

  // The reason why a cell with so few values has no statistic.
  std::string unknown(std::size_t cell, const std::vector<double>& values) const;

  // The claim about `cell` if `needed`, this cell or its reference, cannot be judged, whatever its
  // values are: its world has no goals, or runs are still to be done. None if it can be judged.
  std::optional<Claim> obstacle(std::size_t cell, std::size_t needed) const;

  // `open`: it will be known when all runs are done.
  Claim not_known(std::size_t cell, const std::string& why, bool open = false) const;

  // "3 runs were stopped by the time limit and 1 run failed"
  std::string stopped(std::size_t cell) const;
};

// Judges a cell alone.
Claim judge_cell(const Judging& judging, std::size_t cell);

// Judges a cell relative to its reference.
Claim judge_pair(const Judging& judging, std::size_t cell, std::optional<std::size_t> reference);

}  // namespace elsie::report
