// How long the rest of a batch takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace elsie::batch {

/// Estimates from the times of runs that have ended; it has no clock. A cell's pending runs are
/// expected to take the mean time of its own runs, and of a cell without any, the mean of the other
/// cells. As each seed is done in all cells before the next, every cell soon has a time.
class Estimate {
 public:
  /// `pending`: the number of runs of each cell that are to be done. `workers` of them run at a
  /// time.
  Estimate(std::vector<std::int64_t> pending, std::size_t workers);

  /// `runs` of a cell that were not pending took `wall_s` each, on the clock.
  void add_known(std::size_t cell, double wall_s, std::int64_t runs);
  /// A pending run of a cell has ended after this time.
  void add_ended(std::size_t cell, double wall_s);

  /// In s; none while no time is known, or when nothing is pending.
  std::optional<double> left_s() const;

 private:
  struct Times {
    double sum_s = 0.0;
    std::int64_t runs = 0;
  };

  std::vector<std::int64_t> pending_;
  std::vector<Times> times_;  // of each cell
  std::size_t workers_;
};

}  // namespace elsie::batch
