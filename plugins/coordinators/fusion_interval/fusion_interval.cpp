// Multi-objective command fusion: the command that is best for all behaviours together.
//
// Every behaviour is an objective function over the plane of wheel rates (and the lateral speed, if
// the drive has it); the command maximises their sum, weighted with the priorities. After the helm
// of MOOS-IvP, which solves this by interval programming (Benjamin, 2002). Here a grid finds
// promising regions, and a pattern search (Hooke and Jeeves, 1961) finds their summits.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <elsie/api/remember.h>

#include "candidates.h"
#include "desirability.h"
#include "weighing.h"

namespace {

using elsie::Motion;

class FusionInterval final : public elsie::Coordinator, public elsie::Remembers {
 public:
  int steps = 11;
  int laterals = 5;
  double max_rate = 0.0;
  double tolerance = 0.02;
  int summits = 3;
  double margin = 0.01;
  std::string activation = "scale";

  void configured() override {
    rule_ = activation_rule_of(activation);
    built_for_.reset();
  }
  void equipped(std::span<const elsie::Member> members, const elsie::Perception& example) override {
    build(example);
    starts_.reserve(candidates_.size() + members.size() + 1);
    points_.reserve(starts_.capacity());
    values_.reserve(starts_.capacity());
  }
  void reset(elsie::Random&) override { last_.reset(); }
  void remember(elsie::Memory& memory) override {
    std::optional<std::vector<double>> last;
    if (last_) {
      last = {last_->forward, last_->lateral, last_->turn};
    }
    memory("last", last);
    if (memory.recalls() && last && last->size() == 3) {
      last_ = Motion{(*last)[0], (*last)[1], (*last)[2]};
    }
  }

  Motion coordinate(std::span<elsie::Member> members, const elsie::Perception& now) override {
    build(now);
    if (weigh(members, rule_, "weighed") <= 0.0) {
      last_.reset();
      return {};
    }
    look_everywhere(members);
    std::optional<Point> best;
    for (std::size_t i = 0; i < starts_.size(); ++i) {
      const Point summit = climb(members, {points_[starts_[i]], values_[starts_[i]]});
      if (!best || is_better(summit, *best)) {
        best = summit;
      }
    }
    if (last_) {
      // The last command stays unless another is clearly better.
      const Point summit = climb(members, {*last_, value_of(members, *last_)});
      if (summit.value >= best->value - std::max(margin, kEqual * best->value)) {
        best = summit;
      }
    }
    if (best->value <= 0.0) {
      last_.reset();
      for (elsie::Member& member : members) {
        if (member.trace.weight > 0.0) {
          member.trace.reason = "no command is desirable";
        }
      }
      return {};
    }
    last_ = best->command;
    desirability_.trace_shares(members, best->command);
    return best->command;
  }

  /// The objective function.
  void rate(std::span<elsie::Member> members, const elsie::Perception& /*now*/,
            const Motion& /*given*/, std::span<const Motion> candidates,
            std::span<double> desirability) override {
    outside_.rate(members, candidates, desirability);
  }
  elsie::CommandSets command_sets(std::span<elsie::Member> members,
                                  const elsie::Perception& /*now*/,
                                  const Motion& /*given*/) override {
    return Desirability::sets(members);
  }

 private:
  /// Smaller relative increases are rounding.
  static constexpr double kRounding = 1e-13;

  struct Point {
    Motion command;
    double value;  // mean desirability, in [0, 1]
  };

  void build(const elsie::Perception& now) {
    const double robots = now.self().max_wheel_rate();
    const double limit = max_rate > 0.0 ? max_rate : robots;
    const CommandSpace space(now.self());
    desirability_.set_limit(space, std::min(limit, robots));
    if (built_for_ != limit || space != space_) {
      built_for_ = limit;
      space_ = space;
      candidates_ = Candidates::wheel_rates(space, limit, steps, laterals);
      last_.reset();
    }
  }

  /// Scales a command as a whole to the wheels' limit, as drives do.
  Motion limited(const Motion& command) const {
    const double fastest = space_.fastest(command);
    return fastest > *built_for_ ? *built_for_ / fastest * command : command;
  }

  double value_of(std::span<elsie::Member> members, const Motion& command) {
    double value = 0.0;
    desirability_.rate(members, {&command, 1}, {&value, 1});
    return value;
  }

  /// Rates the grid and each behaviour's wish, and lists the starting points: the highest points
  /// without a higher neighbour.
  void look_everywhere(std::span<elsie::Member> members) {
    points_.assign(candidates_.commands().begin(), candidates_.commands().end());
    for (elsie::Member& member : members) {
      if (member.trace.weight > 0.0) {
        points_.push_back(limited(member.respond().command));
      }
    }
    values_.resize(points_.size());
    desirability_.rate(members, points_, values_);
    starts_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i) {
      bool highest = true;
      candidates_.each_neighbour(
          i, [&](std::size_t next) { highest = highest && values_[next] <= values_[i]; });
      if (highest) {
        starts_.push_back(i);
      }
    }
    const auto kept = std::min(starts_.size(), static_cast<std::size_t>(summits));
    std::partial_sort(starts_.begin(), starts_.begin() + static_cast<std::ptrdiff_t>(kept),
                      starts_.end(), [&](std::size_t a, std::size_t b) {
                        return values_[a] != values_[b] ? values_[a] > values_[b] : a < b;
                      });
    starts_.resize(kept);
  }

  /// Moves to the best of the points around (8, or 26 in three dimensions) while one is better,
  /// then halves the step.
  Point climb(std::span<elsie::Member> members, Point at) {
    std::array<Motion, 26> all_around;
    std::array<double, 26> all_values;
    const int sides = space_.dimensions() > 2 ? 1 : 0;
    const std::size_t points = sides > 0 ? 26 : 8;
    const std::span around = std::span(all_around).first(points);
    const std::span values = std::span(all_values).first(points);
    const double limit = *built_for_;
    for (double step = limit / (steps - 1); step > tolerance;) {
      std::size_t n = 0;
      const CommandSpace::Point from = space_.point(at.command);
      const auto moved = [&](std::size_t axis, int way) {
        return std::clamp(from[axis] + way * step, -limit, limit);
      };
      for (int lateral = -sides; lateral <= sides; ++lateral) {
        for (int left = -1; left <= 1; ++left) {
          for (int right = -1; right <= 1; ++right) {
            if (left != 0 || right != 0 || lateral != 0) {
              around[n++] = space_.motion({moved(0, left), moved(1, right), moved(2, lateral)});
            }
          }
        }
      }
      desirability_.rate(members, around, values);
      const auto best =
          static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
      if (values[best] > at.value * (1.0 + kRounding)) {
        at = {around[best], values[best]};
      } else {
        step *= 0.5;
      }
    }
    return at;
  }

  /// In a tie, the point nearest to the last command, or else to standing still, then the first.
  bool is_better(const Point& a, const Point& b) const {
    if (std::abs(a.value - b.value) > kEqual * std::max(a.value, b.value)) {
      return a.value > b.value;
    }
    const Motion last = last_.value_or(Motion{});
    return space_.distance_squared(a.command, last) < space_.distance_squared(b.command, last);
  }

  ActivationRule rule_ = ActivationRule::scale;
  CommandSpace space_;
  Candidates candidates_;
  Desirability desirability_;
  Desirability outside_;  // without a limit
  std::optional<double> built_for_;
  std::vector<Motion> points_;
  std::vector<double> values_;
  std::vector<std::size_t> starts_;
  std::optional<Motion> last_;
};

}  // namespace

ELSIE_COORDINATOR(
    FusionInterval, "fusion_interval",
    "Finds the best command for all: the highest sum of desirability over all commands",
    elsie::parameter(
        "steps", &FusionInterval::steps,
        {.min = 3, .max = 101, .meaning = "number of rates of each wheel on the first grid"}),
    elsie::parameter(
        "laterals", &FusionInterval::laterals,
        {.min = 1,
         .max = 11,
         .meaning = "number of lateral speeds on the first grid, if the drive can move "
                    "sideways"}),
    elsie::parameter(
        "max_rate", &FusionInterval::max_rate,
        {.unit = "rad/s",
         .min = 0,
         .meaning = "the largest wheel rate; 0: what the robot's maximum speed allows"}),
    elsie::parameter("tolerance", &FusionInterval::tolerance,
                     {.unit = "rad/s", .above = 0, .meaning = "precision of the search"}),
    elsie::parameter("summits", &FusionInterval::summits,
                     {.min = 1,
                      .max = 100,
                      .meaning = "number of grid points from which the search goes uphill"}),
    elsie::parameter("margin", &FusionInterval::margin,
                     {.min = 0,
                      .max = 1,
                      .meaning = "how much better than the last command another must be, as a "
                                 "fraction of the maximum"}),
    elsie::parameter("activation", &FusionInterval::activation, activation_facts()));
