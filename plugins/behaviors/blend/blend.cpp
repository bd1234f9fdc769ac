// A behaviour made of behaviours: what is inside it decides, and to the outside it is one.
#include <elsie/api/behavior.h>

namespace {

class Blend final : public elsie::Behavior {
 public:
  elsie::Coordination* inside = nullptr;

  elsie::Response respond(const elsie::Perception& now) override { return inside->respond(now); }

  // What is desirable to those inside is handed outwards as it is, before anything was settled: an
  // outer fusion is not to work on a command that an inner one has made of many wishes.
  void rate(const elsie::Response& /*given*/, std::span<const elsie::MotorCommand> candidates,
            std::span<double> desirability) const override {
    inside->rate(candidates, desirability);
  }
  elsie::CommandSets command_sets(const elsie::Response& /*given*/) const override {
    return inside->command_sets();
  }
};

}  // namespace

ELSIE_BEHAVIOR(Blend, "blend",
               "Behaviours and their coordinator as one behaviour, so that coordination nests",
               elsie::holds_behaviors(&Blend::inside));
