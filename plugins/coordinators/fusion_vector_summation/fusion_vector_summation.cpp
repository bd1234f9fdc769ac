// Vector summation: the behaviours' commands are added, and divided by their number.
#include <cmath>

#include <elsie/api/coordinator.h>

#include "weighing.h"

namespace {

class FusionVectorSummation final : public elsie::Coordinator {
 public:
  bool weighted = false;

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    elsie::Motion sum;
    for (elsie::Member& member : members) {
      const double weight = weighted ? member.priority() : 1.0;
      const elsie::Motion wish = weight * member.respond().command;
      sum += wish;
      member.trace.weight = weight;
      // Its part in the sum of all commands; if that is zero, in the weights.
      member.trace.share = std::sqrt(now.self().wheels.distance_squared(wish, {}));
      member.trace.reason = weight != 0.0 ? "summed" : "priority zero";
    }
    normalize_shares(members);
    return members.empty() ? sum : sum / static_cast<double>(members.size());
  }
};

}  // namespace

ELSIE_COORDINATOR(
    FusionVectorSummation, "fusion_vector_summation",
    "Adds the commands of all behaviours and divides by their number",
    elsie::parameter("weighted", &FusionVectorSummation::weighted,
                     {.meaning = "whether each command is multiplied by its priority"}));
