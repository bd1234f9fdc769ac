#include "elsie/batch/estimate.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace elsie::batch {

namespace {

constexpr int kSweeps = 20;
constexpr double kShortest_s = 1e-6;  // has a logarithm

}  // namespace

Estimate::Estimate(const std::vector<std::vector<std::string>>& levels,
                   std::vector<std::int64_t> pending, std::size_t workers)
    : pending_(std::move(pending)),
      times_(pending_.size()),
      workers_(std::max<std::size_t>(workers, 1)) {
  std::vector<std::map<std::string, std::size_t>> numbers(levels.empty() ? 0 : levels[0].size());
  for (const std::vector<std::string>& labels : levels) {
    std::vector<std::size_t>& cell = levels_.emplace_back();
    for (std::size_t factor = 0; factor < numbers.size(); ++factor) {
      cell.push_back(
          numbers[factor].try_emplace(labels[factor], numbers[factor].size()).first->second);
    }
  }
  for (const auto& of_factor : numbers) {
    level_counts_.push_back(of_factor.size());
  }
}

void Estimate::add_known(std::size_t cell, double wall_s, std::int64_t runs) {
  times_[cell].sum_s += wall_s * static_cast<double>(runs);
  times_[cell].runs += runs;
}

void Estimate::add_ended(std::size_t cell, double wall_s) {
  add_known(cell, wall_s, 1);
  --pending_[cell];
}

/// The time that a run of each cell is expected to take.
std::vector<double> Estimate::expected_s() const {
  std::vector<double> expected(times_.size(), 0.0);
  std::vector<std::size_t> known;
  double mean_log = 0.0;
  for (std::size_t cell = 0; cell < times_.size(); ++cell) {
    if (times_[cell].runs > 0) {
      expected[cell] = times_[cell].sum_s / static_cast<double>(times_[cell].runs);
      known.push_back(cell);
      mean_log += std::log(std::max(expected[cell], kShortest_s));
    }
  }
  if (known.size() == times_.size() || known.empty()) {
    return expected;
  }
  mean_log /= static_cast<double>(known.size());
  std::vector<std::vector<double>> effects;
  for (const std::size_t count : level_counts_) {
    effects.emplace_back(count, 0.0);
  }
  const auto fitted = [&](std::size_t cell) {
    double sum = mean_log;
    for (std::size_t factor = 0; factor < effects.size(); ++factor) {
      sum += effects[factor][levels_[cell][factor]];
    }
    return sum;
  };
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t factor = 0; factor < effects.size(); ++factor) {
      std::vector<double> sums(level_counts_[factor], 0.0), counts(level_counts_[factor], 0.0);
      for (const std::size_t cell : known) {
        const std::size_t level = levels_[cell][factor];
        sums[level] += std::log(std::max(expected[cell], kShortest_s)) - fitted(cell);
        counts[level] += 1.0;
      }
      for (std::size_t level = 0; level < sums.size(); ++level) {
        effects[factor][level] += counts[level] > 0.0 ? sums[level] / counts[level] : 0.0;
      }
    }
  }
  for (std::size_t cell = 0; cell < times_.size(); ++cell) {
    if (times_[cell].runs == 0) {
      expected[cell] = std::exp(fitted(cell));
    }
  }
  return expected;
}

std::optional<double> Estimate::left_s() const {
  const bool any_known =
      std::any_of(times_.begin(), times_.end(), [](const Times& times) { return times.runs > 0; });
  const bool any_pending =
      std::any_of(pending_.begin(), pending_.end(), [](std::int64_t count) { return count > 0; });
  if (!any_known || !any_pending) {
    return std::nullopt;
  }
  const std::vector<double> expected = expected_s();
  double sum_s = 0.0, longest_s = 0.0;
  for (std::size_t cell = 0; cell < pending_.size(); ++cell) {
    if (pending_[cell] > 0) {
      sum_s += expected[cell] * static_cast<double>(pending_[cell]);
      longest_s = std::max(longest_s, expected[cell]);
    }
  }
  return std::max(sum_s / static_cast<double>(workers_), longest_s);
}

}  // namespace elsie::batch
