// Voting after DAMN, the distributed architecture for mobile navigation (Rosenblatt, 1997): every
// behaviour votes on each of a set of commands, and the command with the most votes is executed.
#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <elsie/api/remember.h>

#include "candidates.h"
#include "desirability.h"
#include "weighing.h"

namespace {

struct Candidate {
  double left = 0.0;
  double right = 0.0;
  double lateral = 0.0;
};

class ArbiterVoting final : public elsie::Coordinator, public elsie::Remembers {
 public:
  std::string set = "wheels";
  int steps = 21;
  int speeds = 4;
  int laterals = 5;
  double max_rate = 0.0;
  double smoothing = 0.0;
  bool interpolate = true;
  double margin = 0.0;
  std::string activation = "scale";
  std::vector<Candidate> listed;

  void configured() override {
    rule_ = activation_rule_of(activation);
    built_for_.reset();
  }
  void equipped(std::span<const elsie::Member>, const elsie::Perception& example) override {
    build(example);
  }
  void reset(elsie::Random&) override { forget(); }
  void remember(elsie::Memory& memory) override {
    memory("last.forward", last_.forward);
    memory("last.lateral", last_.lateral);
    memory("last.turn", last_.turn);
    memory("elected", elected_);
    if (elected_ && *elected_ >= candidates_.size()) {  // of another set of candidates
      elected_.reset();
    }
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    build(now);
    if (weigh(members, rule_, "voted") <= 0.0) {
      forget();
      return {};
    }
    desirability_.rate(members, candidates_.commands(), votes_);
    smoothing_.apply(votes_);
    const double most = *std::max_element(votes_.begin(), votes_.end());
    if (most <= 0.0) {
      forget();
      for (elsie::Member& member : members) {
        if (member.trace.weight > 0.0) {
          member.trace.reason = "no vote for any candidate";
        }
      }
      return {};
    }
    elected_ = elect(most);
    last_ = interpolate ? candidates_.interpolated(*elected_, votes_)
                        : candidates_.commands()[*elected_];
    desirability_.trace_shares(members, last_);
    return last_;
  }

  /// The mean vote.
  void rate(std::span<elsie::Member> members, const elsie::Perception& /*now*/,
            const elsie::Motion& /*given*/, std::span<const elsie::Motion> candidates,
            std::span<double> desirability) override {
    outside_.rate(members, candidates, desirability);
  }
  elsie::CommandSets command_sets(std::span<elsie::Member> members,
                                  const elsie::Perception& /*now*/,
                                  const elsie::Motion& /*given*/) override {
    return Desirability::sets(members);
  }

 private:
  void forget() {
    elected_.reset();
    last_ = {};
  }

  /// The candidates depend on the robot's maximum speed, which may change at any time.
  void build(const elsie::Perception& now) {
    const double robots = now.self().max_wheel_rate();
    const double limit = max_rate > 0.0 ? max_rate : robots;
    const CommandSpace space(now.self());
    desirability_.set_limit(space, std::min(limit, robots));
    if (built_for_ == limit && space == space_) {
      return;
    }
    built_for_ = limit;
    space_ = space;
    if (!listed.empty()) {
      std::vector<elsie::Motion> commands;
      for (const Candidate& candidate : listed) {
        commands.push_back(now.self().wheels.motion({candidate.left, candidate.right}));
        commands.back().lateral = candidate.lateral;
      }
      candidates_ = Candidates::list(std::move(commands));
    } else {
      candidates_ = set == "arcs" ? Candidates::arcs(space, limit, speeds, steps)
                                  : Candidates::wheel_rates(space, limit, steps, laterals);
    }
    smoothing_.prepare(space, candidates_.commands(), smoothing);
    votes_.resize(candidates_.size());
    elected_.reset();
  }

  std::size_t elect(double most) const {
    // The last winner stays unless another candidate has clearly more votes; or rather, the best
    // candidate near it stays, because votes change a little with every step.
    if (elected_ && margin > 0.0) {
      const std::size_t near = summit_near(*elected_);
      if (votes_[near] >= most - margin) {
        return near;
      }
    }
    // In a tie, the one nearest to the last command, then the first.
    std::size_t best = votes_.size();
    for (std::size_t i = 0; i < votes_.size(); ++i) {
      if (votes_[i] >= most * (1.0 - kEqual) && (best == votes_.size() || away(i) < away(best))) {
        best = i;
      }
    }
    return best;
  }

  double away(std::size_t candidate) const {
    return space_.distance_squared(candidates_.commands()[candidate], last_);
  }

  /// Moves uphill from candidate to candidate until no neighbour has more votes.
  std::size_t summit_near(std::size_t at) const {
    for (;;) {
      std::size_t best = at;
      candidates_.each_neighbour(at, [&](std::size_t next) {
        if (votes_[next] > votes_[best]) {
          best = next;
        }
      });
      if (best == at) {
        return at;
      }
      at = best;
    }
  }

  ActivationRule rule_ = ActivationRule::scale;
  CommandSpace space_;
  Candidates candidates_;
  Smoothing smoothing_;
  Desirability desirability_;
  Desirability outside_;  // without a limit
  std::optional<double> built_for_;
  std::vector<double> votes_;           // mean over all members, in [0, 1]
  std::optional<std::size_t> elected_;  // the last winner
  elsie::Motion last_;
};

}  // namespace

ELSIE_COORDINATOR(
    ArbiterVoting, "arbiter_voting",
    "Every behaviour votes on a set of commands; the command with the most votes wins",
    elsie::parameter(
        "set", &ArbiterVoting::set,
        {.choices = {"wheels", "arcs"},
         .meaning = "the candidates: 'wheels', all pairs of wheel rates; 'arcs', forward arcs from "
                    "turning in place to straight on, at several speeds, and standing still"}),
    elsie::parameter("steps", &ArbiterVoting::steps,
                     {.min = 2,
                      .max = 41,
                      .meaning = "how many rates of each wheel, or how many arcs of each speed"}),
    elsie::parameter("speeds", &ArbiterVoting::speeds,
                     {.min = 1, .max = 41, .meaning = "how many speeds the arcs are driven at"}),
    elsie::parameter("laterals", &ArbiterVoting::laterals,
                     {.min = 1,
                      .max = 11,
                      .meaning = "how many lateral speeds for each pair of wheel rates, if the "
                                 "drive can move sideways"}),
    elsie::parameter("max_rate", &ArbiterVoting::max_rate,
                     {.unit = "rad/s",
                      .min = 0,
                      .meaning = "the largest wheel rate of a candidate; 0: what the robot's "
                                 "maximum speed allows"}),
    elsie::parameter("smoothing", &ArbiterVoting::smoothing,
                     {.unit = "rad/s",
                      .min = 0,
                      .meaning = "standard deviation of the Gaussian that spreads votes over near "
                                 "candidates; 0: none"}),
    elsie::parameter("interpolate", &ArbiterVoting::interpolate,
                     {.meaning = "whether the command may lie between candidates, at the top of "
                                 "parabolas through the votes"}),
    elsie::parameter(
        "margin", &ArbiterVoting::margin,
        {.min = 0,
         .max = 1,
         .meaning =
             "how many more votes than the last command another one needs, as a fraction of all"}),
    elsie::parameter("activation", &ArbiterVoting::activation, activation_facts()),
    elsie::elements(&ArbiterVoting::listed,
                    elsie::element<Candidate>(
                        "candidate", "a command to vote on; if any is given, only these are used",
                        elsie::parameter("left", &Candidate::left,
                                         {.unit = "rad/s", .meaning = "rate of the left wheel"}),
                        elsie::parameter("right", &Candidate::right,
                                         {.unit = "rad/s", .meaning = "rate of the right wheel"}),
                        elsie::parameter("lateral", &Candidate::lateral,
                                         {.unit = "m/s",
                                          .meaning = "speed to the left, if the drive can move "
                                                     "sideways"}))));
