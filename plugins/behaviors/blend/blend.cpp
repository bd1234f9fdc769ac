// A behaviour that consists of behaviours with a coordinator of their own.
#include <elsie/api/behavior.h>

namespace {

class Blend final : public elsie::Behavior {
 public:
  elsie::Coordination* inside = nullptr;

  elsie::Response respond(const elsie::Perception& now) override { return inside->respond(now); }

  // The inner behaviours' ratings are passed outwards before any decision: an outer fusion should
  // not work on a command that an inner one has made of many wishes.
  void rate(const elsie::Perception& /*now*/, const elsie::Response& /*given*/,
            std::span<const elsie::Motion> candidates,
            std::span<double> desirability) const override {
    inside->rate(candidates, desirability);
  }
  elsie::CommandSets command_sets(const elsie::Perception& /*now*/,
                                  const elsie::Response& /*given*/) const override {
    return inside->command_sets();
  }
};

}  // namespace

ELSIE_BEHAVIOR(Blend, "blend",
               "Behaviours and their coordinator as one behaviour, so that coordination nests",
               elsie::holds_behaviors(&Blend::inside));
