// How often the intervals of the report contain the true value, by simulation.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace elsie::test {

/// The sizes of the samples: seeds for each cell.
inline constexpr std::size_t kSeedsOfCoverage[] = {5, 10, 20};

struct CoverageRow {
  std::string interval;  // "mean: bootstrap-t"
  std::string drawn;     // "log-normal (sigma 1)"
  /// The part of the experiments that held the truth, of those with an interval; none where there
  /// is none.
  std::vector<std::optional<double>> held;  // for each of kSeedsOfCoverage
};

/// Simulates so many experiments for each number; seeded, so that fewer are the first of more.
std::vector<CoverageRow> simulate_coverage(int experiments);

/// The rows of a table in Markdown.
std::string coverage_table(const std::vector<CoverageRow>& rows);

}  // namespace elsie::test
