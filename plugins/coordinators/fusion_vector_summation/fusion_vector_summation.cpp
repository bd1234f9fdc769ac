// Vector summation: the behaviours' commands are added, and divided by their number.
#include <cmath>

#include <elsie/api/coordinator.h>

namespace {

class FusionVectorSummation final : public elsie::Coordinator {
 public:
  bool weighted = false;

  elsie::MotorCommand coordinate(std::span<elsie::Member> members,
                                 const elsie::Perception&) override {
    elsie::MotorCommand sum;
    double effort = 0.0;  // of all behaviours together, to tell each one's share
    for (elsie::Member& member : members) {
      const double weight = weighted ? member.priority() : 1.0;
      const elsie::MotorCommand wish = weight * member.respond().command;
      sum += wish;
      member.trace.weight = weight;
      member.trace.share = std::hypot(wish.left, wish.right);
      member.trace.reason = "summed";
      effort += member.trace.share;
    }
    if (effort > 0.0) {
      for (elsie::Member& member : members) {
        member.trace.share /= effort;
      }
    }
    return members.empty() ? sum : sum / static_cast<double>(members.size());
  }
};

}  // namespace

ELSIE_COORDINATOR(
    FusionVectorSummation, "fusion_vector_summation",
    "Adds the commands of all behaviours and divides by their number",
    elsie::parameter(
        "weighted", &FusionVectorSummation::weighted,
        {.meaning = "whether each command counts as many times as its priority says"}));
