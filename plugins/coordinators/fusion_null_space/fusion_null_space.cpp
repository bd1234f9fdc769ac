// Null-space-based behavioural control: Antonelli, Arrichiello and Chiaverini, "The
// null-space-based behavioral control for autonomous robotic systems", Intelligent Service Robotics
// 1, 2008. A task acts only where those above it leave freedom.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "weighing.h"

namespace {

/// A motion as the velocity of a point ahead of the robot: forward, across, and, with a drive that
/// moves to the side, what the turn adds across.
using Velocity = std::array<double, 3>;

double dot(const Velocity& a, const Velocity& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
Velocity sum(const Velocity& a, double factor, const Velocity& b) {
  return {a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]};
}

class FusionNullSpace final : public elsie::Coordinator {
 public:
  double lookahead = 0.1;

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    sort(members);
    taken_.clear();
    has_side_ = now.self().channels.lateral;
    const std::size_t dimensions = has_side_ ? 3 : 2;
    Velocity whole{};
    int first = -1;
    for (const std::size_t i : order_) {
      elsie::Member& member = members[i];
      elsie::TraceRow& trace = member.trace;
      if (taken_.size() == dimensions) {
        trace.reason = "no freedom left";
        trace.inhibited_by = first;
        continue;
      }
      const elsie::Response& response = member.respond();
      if (!(response.activation > 0.0)) {
        trace.reason = "not active";
        continue;
      }
      const Velocity part = free_part(response, dimensions);
      whole = sum(whole, 1.0, part);
      trace.weight = 1.0;
      trace.share = std::sqrt(dot(part, part));
      trace.reason = first < 0           ? "first task"
                     : trace.share > 0.0 ? "in the freedom left"
                                         : "nothing in the freedom left";
      if (first < 0) first = static_cast<int>(i);
    }
    normalize_shares(members);
    return motion(whole);
  }

 private:
  /// By falling priority, in the order of the file among equals.
  void sort(std::span<const elsie::Member> members) {
    order_.resize(members.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::stable_sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return members[a].priority() > members[b].priority();
    });
  }

  Velocity velocity(const elsie::Motion& motion) const {
    const double ahead = lookahead * motion.turn;
    return has_side_ ? Velocity{motion.forward, motion.lateral, ahead}
                     : Velocity{motion.forward, ahead, 0.0};
  }
  elsie::Motion motion(const Velocity& velocity) const {
    return has_side_ ? elsie::Motion{velocity[0], velocity[1], velocity[2] / lookahead}
                     : elsie::Motion{velocity[0], 0.0, velocity[1] / lookahead};
  }

  /// What of a task's velocity lies where those before it leave freedom; that freedom is then
  /// taken.
  Velocity free_part(const elsie::Response& response, std::size_t dimensions) {
    const Velocity wanted = velocity(response.command);
    Velocity part{};
    if (response.matters_rad) {
      const Velocity along{std::cos(*response.matters_rad), std::sin(*response.matters_rad), 0.0};
      // The task is the velocity along that direction; what others do across it is not its own.
      part = free_of_taken(sum({}, dot(along, wanted), along));
      take(along);
    } else {
      part = free_of_taken(wanted);
      for (std::size_t i = 0; i < dimensions; ++i) {
        Velocity axis{};
        axis[i] = 1.0;
        take(axis);
      }
    }
    return part;
  }

  Velocity free_of_taken(Velocity velocity) const {
    for (const Velocity& direction : taken_) {
      velocity = sum(velocity, -dot(direction, velocity), direction);
    }
    return velocity;
  }

  /// Adds a direction to an orthonormal basis of what is taken, unless it lies in that.
  void take(const Velocity& direction) {
    constexpr double kRounding = 1e-6;
    const Velocity rest = free_of_taken(direction);
    const double length = std::sqrt(dot(rest, rest));
    if (length > kRounding) taken_.push_back(sum({}, 1.0 / length, rest));
  }

  std::vector<std::size_t> order_;
  std::vector<Velocity> taken_;  // of this step
  bool has_side_ = false;
};

}  // namespace

ELSIE_COORDINATOR(
    FusionNullSpace, "fusion_null_space",
    "Tasks by priority: a lower one acts only where the higher ones leave freedom",
    elsie::parameter("lookahead", &FusionNullSpace::lookahead,
                     {.unit = "m",
                      .above = 0,
                      .max = 10,
                      .meaning = "how far ahead of the robot the point is whose velocity the tasks "
                                 "share"}));
