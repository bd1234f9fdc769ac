#include "elsie/batch/estimate.h"

#include <algorithm>
#include <utility>

namespace elsie::batch {

Estimate::Estimate(std::vector<std::int64_t> pending, std::size_t workers)
    : pending_(std::move(pending)),
      times_(pending_.size()),
      workers_(std::max<std::size_t>(workers, 1)) {}

void Estimate::add_known(std::size_t cell, double wall_s, std::int64_t runs) {
  times_[cell].sum_s += wall_s * static_cast<double>(runs);
  times_[cell].runs += runs;
}

void Estimate::add_ended(std::size_t cell, double wall_s) {
  add_known(cell, wall_s, 1);
  --pending_[cell];
}

std::optional<double> Estimate::left_s() const {
  const auto mean_s = [](const Times& times) {
    return times.sum_s / static_cast<double>(times.runs);
  };
  double sum_of_means_s = 0.0, known = 0.0;
  for (const Times& times : times_) {
    if (times.runs > 0) {
      sum_of_means_s += mean_s(times);
      known += 1.0;
    }
  }
  const bool any_pending =
      std::any_of(pending_.begin(), pending_.end(), [](std::int64_t count) { return count > 0; });
  if (known == 0.0 || !any_pending) {
    return std::nullopt;
  }
  double sum_s = 0.0, longest_s = 0.0;
  for (std::size_t cell = 0; cell < pending_.size(); ++cell) {
    if (pending_[cell] > 0) {
      const double expected_s =
          times_[cell].runs > 0 ? mean_s(times_[cell]) : sum_of_means_s / known;
      sum_s += expected_s * static_cast<double>(pending_[cell]);
      longest_s = std::max(longest_s, expected_s);
    }
  }
  return std::max(sum_s / static_cast<double>(workers_), longest_s);
}

}  // namespace elsie::batch
