// Resolution by strength, after the priority resolver of ARIA: every behaviour gives its command
// and its strength, for each channel of the drive separately. The strength of a channel is filled
// up to one, from the highest priority downwards.
#include <algorithm>
#include <array>
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
  double lateral = 1.0;
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

  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception& now) override;

 private:
  static constexpr std::size_t kChannels = 3;  // forward, lateral, turn

  struct Channel {
    bool exists = true;  // in the robot's drive
    double taken = 0.0;  // strength so far, up to 1
    double sum = 0.0;    // of value x strength
    int filled_by = -1;  // the last behaviour that contributed

    bool full() const { return !exists || taken >= 1.0 - 1e-12; }
    double value() const { return taken > 0.0 ? sum / taken : 0.0; }
  };
  /// One member's strengths in this step, and the parts of them that it received.
  struct Bid {
    std::array<double, kChannels> asked{};
    std::array<double, kChannels> taken{};

    static double sum(const std::array<double, kChannels>& strengths) {
      return strengths[0] + strengths[1] + strengths[2];
    }
  };

  void assign();
  bool full() const {
    return std::all_of(channels_.begin(), channels_.end(),
                       [](const Channel& c) { return c.full(); });
  }
  Bid bid_of(std::span<elsie::Member> members, std::size_t i) const;
  void resolve(std::span<elsie::Member> members, std::span<const std::size_t> group);
  void trace(std::span<elsie::Member> members);

  ActivationRule rule_ = ActivationRule::scale;
  std::vector<std::string> names_;
  std::vector<Strength> factors_;   // for each member
  std::vector<std::size_t> order_;  // indices of the members, by priority
  std::vector<Bid> bids_;
  std::array<Channel, kChannels> channels_;
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
  Bid bid;
  bid.asked = {in_range(strength * response.speed_strength * factors_[i].speed),
               in_range(strength * response.lateral_strength * factors_[i].lateral),
               in_range(strength * response.turn_strength * factors_[i].turn)};
  for (std::size_t c = 0; c < kChannels; ++c) {
    bid.asked[c] = channels_[c].exists ? bid.asked[c] : 0.0;
  }
  return bid;
}

elsie::Motion ArbiterStrength::coordinate(std::span<elsie::Member> members,
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
  const elsie::Channels has = now.self().channels;
  channels_ = {Channel{has.forward}, Channel{has.lateral}, Channel{has.turn}};
  for (std::size_t first = 0; first < order_.size() && !full();) {
    std::size_t end = first;
    while (end < order_.size() &&
           members[order_[end]].priority() == members[order_[first]].priority()) {
      ++end;
    }
    resolve(members, std::span(order_).subspan(first, end - first));
    first = end;
  }
  trace(members);
  return {channels_[0].value(), channels_[1].value(), channels_[2].value()};
}

/// Distributes the remaining strength to the members of one priority.
void ArbiterStrength::resolve(std::span<elsie::Member> members,
                              std::span<const std::size_t> group) {
  for (const std::size_t i : group) {
    bids_[i] = bid_of(members, i);
  }
  for (std::size_t c = 0; c < kChannels; ++c) {
    Channel& channel = channels_[c];
    double asked = 0.0;
    for (const std::size_t i : group) {
      asked += bids_[i].asked[c];
    }
    // Each gets its part of the remaining strength, or all that it asks for if there is enough.
    const double part = asked > 0.0 ? std::min(1.0, (1.0 - channel.taken) / asked) : 0.0;
    for (const std::size_t i : group) {
      const elsie::Motion& wish = members[i].respond().command;
      const double taken = part * bids_[i].asked[c];
      bids_[i].taken[c] = taken;
      channel.sum += taken * std::array{wish.forward, wish.lateral, wish.turn}[c];
      channel.taken += taken;
      if (taken > 0.0) {
        channel.filled_by = static_cast<int>(i);
      }
    }
  }
}

void ArbiterStrength::trace(std::span<elsie::Member> members) {
  // By the channels in which a member has all the strength that it asks for: 1, 2 and 4.
  static constexpr std::array<const char*, 8> kFull{"full strength",
                                                    "full strength: speed",
                                                    "full strength: lateral",
                                                    "full strength: speed and lateral",
                                                    "full strength: turn",
                                                    "full strength: speed and turn",
                                                    "full strength: lateral and turn",
                                                    "full strength"};
  int existing = 0;
  int filled = 0;
  unsigned all = 0;
  for (std::size_t c = 0; c < kChannels; ++c) {
    existing += channels_[c].exists ? 1 : 0;
    filled += channels_[c].taken > 0.0 ? 1 : 0;
    all |= channels_[c].exists ? 1U << c : 0U;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Bid& bid = bids_[i];
    elsie::TraceRow& row = members[i].trace;
    const double asked = Bid::sum(bid.asked);
    const double taken = Bid::sum(bid.taken);
    row.weight = existing > 0 ? taken / existing : 0.0;
    unsigned part = 0;
    std::size_t wanted = kChannels;  // the first channel that it asks for
    for (std::size_t c = 0; c < kChannels; ++c) {
      if (channels_[c].taken > 0.0) {
        row.share += bid.taken[c] / channels_[c].taken / filled;
      }
      part |= bid.taken[c] > 0.0 ? 1U << c : 0U;
      const bool wants = channels_[c].exists && (bid.asked[c] > 0.0 || !row.asked);
      wanted = wanted == kChannels && wants ? c : wanted;
    }
    if (!row.asked || (asked > 0.0 && taken <= 0.0)) {
      row.inhibited_by = wanted < kChannels ? channels_[wanted].filled_by : -1;
      row.reason = "no strength left";
    } else if (asked <= 0.0) {
      row.reason = row.activation > 0.0 ? "no strength" : "not active";
    } else if (taken < asked * (1.0 - 1e-9)) {
      row.reason = "fills what is left";
    } else {
      row.reason = part == all ? "full strength" : kFull[part];
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
                        elsie::parameter("lateral", &Strength::lateral,
                                         {.min = 0, .max = 1, .meaning = "for its lateral speed"}),
                        elsie::parameter("turn", &Strength::turn,
                                         {.min = 0, .max = 1, .meaning = "for its turn"}))));
