// Estimates of the remaining time from made-up times: nothing here has a clock.
#include <algorithm>
#include <queue>
#include <vector>

#include <catch2/catch.hpp>

#include "elsie/base/random.h"
#include "elsie/batch/estimate.h"

using namespace elsie;
using batch::Estimate;

namespace {

/// A batch whose runs take made-up times: cells of 3 worlds and 4 speeds, which differ by a factor
/// of 10, and runs of a cell that differ by up to a tenth.
class MadeUpBatch {
 public:
  static constexpr std::size_t kWorlds = 3, kSpeeds = 4;

  MadeUpBatch(int seeds, std::size_t workers) : workers_(workers), random_(1, "times") {
    const double of_world[] = {1.0, 2.0, 4.0}, of_speed[] = {2.5, 2.0, 1.5, 1.0};
    for (std::size_t world = 0; world < kWorlds; ++world) {
      for (std::size_t speed = 0; speed < kSpeeds; ++speed) {
        levels_.push_back({std::to_string(world), std::to_string(speed)});
        mean_s_.push_back(of_world[world] * of_speed[speed]);
      }
    }
    for (int seed = 0; seed < seeds; ++seed) {
      for (std::size_t cell = 0; cell < levels_.size(); ++cell) {
        runs_.push_back({cell, mean_s_[cell] * random_.uniform(0.9, 1.1)});
      }
    }
  }

  struct Judged {
    double estimate_s;
    double truth_s;
    double error() const { return std::abs(estimate_s / truth_s - 1.0); }
  };
  /// The estimate when so many runs have ended, and how long the others really take.
  Judged after(std::size_t ended) const {
    Estimate estimate(levels_, std::vector<std::int64_t>(levels_.size(), runs_per_cell()),
                      workers_);
    // The workers take the runs in order; the time when each ends.
    std::priority_queue<double, std::vector<double>, std::greater<>> free_at;
    for (std::size_t i = 0; i < workers_; ++i) {
      free_at.push(0.0);
    }
    std::vector<std::pair<double, std::size_t>> ends;  // and the run
    for (std::size_t i = 0; i < runs_.size(); ++i) {
      const double end_s = free_at.top() + runs_[i].wall_s;
      free_at.pop();
      free_at.push(end_s);
      ends.emplace_back(end_s, i);
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t i = 0; i < ended; ++i) {
      const Run& run = runs_[ends[i].second];
      estimate.add_ended(run.cell, run.wall_s);
    }
    return {estimate.left_s().value(), ends.back().first - ends[ended - 1].first};
  }

  std::size_t cells() const { return levels_.size(); }
  double slowest_to_fastest() const {
    const auto [least, most] = std::minmax_element(mean_s_.begin(), mean_s_.end());
    return *most / *least;
  }

 private:
  struct Run {
    std::size_t cell;
    double wall_s;
  };
  std::int64_t runs_per_cell() const {
    return static_cast<std::int64_t>(runs_.size() / levels_.size());
  }

  std::size_t workers_;
  Random random_;
  std::vector<std::vector<std::string>> levels_;
  std::vector<double> mean_s_;
  std::vector<Run> runs_;  // in the order in which they are done
};

}  // namespace

TEST_CASE("After one seed of all cells, the estimate is right within 20 %") {
  for (const std::size_t workers : {1U, 2U, 4U}) {
    CAPTURE(workers);
    const MadeUpBatch batch(20, workers);
    REQUIRE(batch.slowest_to_fastest() == Approx(10.0));
    CHECK(batch.after(batch.cells()).error() < 0.2);
    CHECK(batch.after(10 * batch.cells()).error() < 0.2);
  }
}

TEST_CASE("Cells without runs take the time that their levels suggest") {
  const MadeUpBatch batch(20, 1);
  // The first world, and one speed of the second: the mean of these alone is a third of the truth.
  CHECK(batch.after(MadeUpBatch::kSpeeds + 1).error() > 0.2);
  // One speed of the third world, too.
  CHECK(batch.after(2 * MadeUpBatch::kSpeeds + 1).error() < 0.2);
}

TEST_CASE("The last runs do not become faster by more workers") {
  Estimate estimate({{"a", "1"}, {"a", "2"}}, {1, 1}, 16);
  estimate.add_known(0, 30.0, 4);
  estimate.add_known(1, 10.0, 4);
  CHECK(estimate.left_s() == 30.0);
  estimate.add_ended(0, 30.0);
  CHECK(estimate.left_s() == 10.0);
}

TEST_CASE("Without any time, or without pending runs, there is no estimate") {
  Estimate estimate({{"a"}, {"b"}}, {1, 0}, 2);
  CHECK_FALSE(estimate.left_s());
  estimate.add_known(1, 2.0, 3);  // of an earlier batch
  CHECK(estimate.left_s() == Approx(2.0));
  estimate.add_ended(0, 5.0);
  CHECK_FALSE(estimate.left_s());
  CHECK_FALSE(Estimate({}, {}, 1).left_s());
}
