// Arbitration with learned priorities: only the behaviour with the largest output of the network
// runs.
#include <algorithm>

#include "priority_network.h"
#include "winner.h"

namespace {

class ArbiterNeuralNetwork final : public WithPriorityNetwork<WinnerTakesAll> {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (members.empty()) {
      return nobody(members, "");
    }
    const std::span<const double> priority = priorities(now);
    // The first of equally large ones.
    const auto winner = std::max_element(priority.begin(), priority.end()) - priority.begin();
    const elsie::Motion command = let_decide(members, static_cast<std::size_t>(winner),
                                             "largest priority", "smaller priority");
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i].trace.weight = priority[i];
    }
    return command;
  }
};

}  // namespace

ELSIE_COORDINATOR(ArbiterNeuralNetwork, "arbiter_neural_network",
                  "Runs only the behaviour to which a neural network gives the largest priority; "
                  "the first in the file wins a tie",
                  elsie::needs<elsie::RangeReading>(), PRIORITY_NETWORK_PARAMETERS);
