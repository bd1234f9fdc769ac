// Resolution by strength, after the priority resolver of ARIA: every behaviour gives its command
// and its strength, for speed and turn separately. The strength of a channel is filled up to one,
// from the highest priority downwards.
#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/coordinator.h>
#include <elsie/base/near_name.h>

#include "weighing.h"

namespace {

struct Strength {
  std::string of;
  double speed = 1.0;
  double turn = 1.0;
};

class ArbiterStrength final : public elsie::Coordinator {
 public:
  std::string activation = "scale";
  std::vector<Strength> strengths;

  void configured() override {
    rule_ = activation_rule_of(activation);
    if (!names_.empty()) {
      assign();
    }
  }

  void equipped(std::span<const elsie::Member> members, const elsie::Perception&) override {
    names_.clear();
    for (const elsie::Member& member : members) {
      names_.emplace_back(member.name());
    }
    assign();
  }

  elsie::MotorCommand coordinate(std::span<elsie::Member> members,
                                 const elsie::Perception& now) override;

 private:
  struct Channel {
    double taken = 0.0;  // strength so far, up to 1
    double sum = 0.0;    // of value x strength
    int filled_by = -1;  // the last behaviour that contributed

    bool full() const { return taken >= 1.0 - 1e-12; }
    double value() const { return taken > 0.0 ? sum / taken : 0.0; }
  };
  /// One member's response in this step, and the strength that it got.
  struct Bid {
    double speed = 0.0;  // strengths
    double turn = 0.0;
    double speed_taken = 0.0;
    double turn_taken = 0.0;
  };

  void assign();
  Bid bid_of(std::span<elsie::Member> members, std::size_t i) const;
  void resolve(std::span<elsie::Member> members, std::span<const std::size_t> group);
  void trace(std::span<elsie::Member> members);

  ActivationRule rule_ = ActivationRule::scale;
  std::vector<std::string> names_;
  std::vector<Strength> factors_;   // for each member
  std::vector<std::size_t> order_;  // indices of the members, by priority
  std::vector<Bid> bids_;
  Channel speed_;
  Channel turn_;
};

void ArbiterStrength::assign() {
  factors_.assign(names_.size(), {});
  std::string problems;
  for (const Strength& strength : strengths) {
    const auto found = std::find(names_.begin(), names_.end(), strength.of);
    if (found == names_.end()) {
      problems += (problems.empty() ? "" : "; ") +
                  ("<strength of=\"" + strength.of + "\"> names no behaviour of this coordinator" +
                   elsie::base::did_you_mean(strength.of, names_));
      continue;
    }
    Strength& factor = factors_[static_cast<std::size_t>(found - names_.begin())];
    if (!factor.of.empty()) {
      problems += (problems.empty() ? "" : "; ") +
                  ("<strength of=\"" + strength.of + "\"> is given twice; remove one");
    }
    factor = strength;
  }
  if (!problems.empty()) {
    throw std::invalid_argument(problems);
  }
}

ArbiterStrength::Bid ArbiterStrength::bid_of(std::span<elsie::Member> members,
                                             std::size_t i) const {
  const elsie::Response& response = members[i].respond();
  const double strength = response.strength * factor_of(rule_, response.activation);
  const auto in_range = [](double value) { return value > 0.0 ? std::min(value, 1.0) : 0.0; };
  return {in_range(strength * response.speed_strength * factors_[i].speed),
          in_range(strength * response.turn_strength * factors_[i].turn), 0.0, 0.0};
}

elsie::MotorCommand ArbiterStrength::coordinate(std::span<elsie::Member> members,
                                                const elsie::Perception& now) {
  if (members.size() != names_.size()) {
    equipped(members, now);
  }
  order_.resize(members.size());
  for (std::size_t i = 0; i < order_.size(); ++i) {
    order_[i] = i;
  }
  std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
    const double before = members[a].priority();
    const double after = members[b].priority();
    return before != after ? before > after : a < b;
  });
  bids_.assign(members.size(), {});
  speed_ = turn_ = {};
  for (std::size_t first = 0; first < order_.size() && !(speed_.full() && turn_.full());) {
    std::size_t end = first;
    while (end < order_.size() &&
           members[order_[end]].priority() == members[order_[first]].priority()) {
      ++end;
    }
    resolve(members, std::span(order_).subspan(first, end - first));
    first = end;
  }
  trace(members);
  const double speed = speed_.value();
  const double turn = turn_.value();
  return {speed - turn, speed + turn};
}

/// Distributes the remaining strength to the members of one priority.
void ArbiterStrength::resolve(std::span<elsie::Member> members,
                              std::span<const std::size_t> group) {
  double speed = 0.0;
  double turn = 0.0;
  for (const std::size_t i : group) {
    bids_[i] = bid_of(members, i);
    speed += bids_[i].speed;
    turn += bids_[i].turn;
  }
  // Each gets its part of the remaining strength, or all that it asks for if there is enough.
  const double speed_part = speed > 0.0 ? std::min(1.0, (1.0 - speed_.taken) / speed) : 0.0;
  const double turn_part = turn > 0.0 ? std::min(1.0, (1.0 - turn_.taken) / turn) : 0.0;
  const auto take = [](Channel& channel, double strength, double value, std::size_t i) {
    channel.sum += strength * value;
    channel.taken += strength;
    if (strength > 0.0) {
      channel.filled_by = static_cast<int>(i);
    }
  };
  for (const std::size_t i : group) {
    const elsie::MotorCommand& wish = members[i].respond().command;
    bids_[i].speed_taken = speed_part * bids_[i].speed;
    bids_[i].turn_taken = turn_part * bids_[i].turn;
    take(speed_, bids_[i].speed_taken, 0.5 * (wish.left + wish.right), i);
    take(turn_, bids_[i].turn_taken, 0.5 * (wish.right - wish.left), i);
  }
}

void ArbiterStrength::trace(std::span<elsie::Member> members) {
  const int channels = (speed_.taken > 0.0) + (turn_.taken > 0.0);
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Bid& bid = bids_[i];
    elsie::TraceRow& row = members[i].trace;
    row.weight = 0.5 * (bid.speed_taken + bid.turn_taken);
    if (speed_.taken > 0.0) {
      row.share += bid.speed_taken / speed_.taken / channels;
    }
    if (turn_.taken > 0.0) {
      row.share += bid.turn_taken / turn_.taken / channels;
    }
    const double asked = bid.speed + bid.turn;
    const double taken = bid.speed_taken + bid.turn_taken;
    if (!row.asked || (asked > 0.0 && taken <= 0.0)) {
      row.inhibited_by = bid.speed > 0.0 || !row.asked ? speed_.filled_by : turn_.filled_by;
      row.reason = "no strength left";
    } else if (asked <= 0.0) {
      row.reason = row.activation > 0.0 ? "no strength" : "not active";
    } else if (taken < asked * (1.0 - 1e-9)) {
      row.reason = "fills what is left";
    } else {
      row.reason = bid.speed_taken <= 0.0  ? "full strength: turn"
                   : bid.turn_taken <= 0.0 ? "full strength: speed"
                                           : "full strength";
    }
  }
}

}  // namespace

ELSIE_COORDINATOR(
    ArbiterStrength, "arbiter_strength",
    "Fills the strength of speed and turn from the highest priority downwards",
    elsie::parameter("activation", &ArbiterStrength::activation,
                     {.choices = {"scale", "gate", "ignore"},
                      .meaning = "what a behaviour's activation does to its strength: 'scale' "
                                 "multiplies, 'gate' leaves out those that are not active, "
                                 "'ignore' does nothing"}),
    elsie::elements(&ArbiterStrength::strengths,
                    elsie::element<Strength>(
                        "strength", "factors of one behaviour's strength",
                        elsie::parameter("of", &Strength::of,
                                         {.meaning = "the behaviour's id", .required = true}),
                        elsie::parameter("speed", &Strength::speed,
                                         {.min = 0, .max = 1, .meaning = "for its forward speed"}),
                        elsie::parameter("turn", &Strength::turn,
                                         {.min = 0, .max = 1, .meaning = "for its turn"}))));
