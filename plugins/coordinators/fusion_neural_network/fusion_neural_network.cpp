// Fusion with learned priorities: the commands, each times the network's output for its behaviour,
// are added and divided by the number of behaviours.
#include <cmath>

#include "priority_network.h"
#include "weighing.h"

namespace {

class FusionNeuralNetwork final : public WithPriorityNetwork<elsie::Coordinator> {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    const std::span<const double> priority = priorities(now);
    elsie::Motion sum;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const elsie::Motion wish = priority[i] * members[i].respond().command;
      sum += wish;
      members[i].trace.weight = priority[i];
      // Its part in the sum of all commands; if that is zero, in the priorities.
      members[i].trace.share = std::sqrt(now.self().wheels.distance_squared(wish, {}));
      members[i].trace.reason = "priority from the network";
    }
    normalize_shares(members);
    return members.empty() ? sum : sum / static_cast<double>(members.size());
  }
};

}  // namespace

ELSIE_COORDINATOR(FusionNeuralNetwork, "fusion_neural_network",
                  "Adds the commands of all behaviours, each times the priority that a neural "
                  "network gives it, and divides by their number",
                  elsie::needs<elsie::RangeReading>(), PRIORITY_NETWORK_PARAMETERS);
