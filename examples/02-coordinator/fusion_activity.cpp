#include <algorithm>

#include <elsie/api/coordinator.h>

// The mean of all wishes, each counted as much as its behaviour is active now.
class FusionActivity final : public elsie::Coordinator {
 public:
  double least = 0.05;

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& /*now*/) override {
    double total = 0.0;
    for (elsie::Member& member : members) {
      const double activation = member.respond().activation;  // runs the behaviour
      const double weight =
          activation < least ? 0.0 : activation * std::max(0.0, member.priority());
      member.trace.weight = weight;
      member.trace.reason = weight > 0.0 ? "active" : "not active";
      total += weight;
    }
    elsie::Motion mean;
    for (elsie::Member& member : members) {
      if (total > 0.0) {
        member.trace.share = member.trace.weight / total;
        mean += member.trace.share * member.respond().command;  // runs once a step only
      }
    }
    return mean;
  }
};

ELSIE_COORDINATOR(
    FusionActivity, "fusion_activity",
    "The mean of all wishes, each counted as much as its behaviour is active now",
    elsie::parameter("least", &FusionActivity::least,
                     {.min = 0, .max = 1, .meaning = "activation below which a wish is left out"}));
