// Suppression by fixed priority: the behaviour of highest priority runs, and no other.
#include <elsie/api/coordinator.h>

namespace {

class ArbiterSuppression final : public elsie::Coordinator {
 public:
  elsie::MotorCommand coordinate(std::span<elsie::Member> members,
                                 const elsie::Perception&) override {
    if (members.empty()) {
      return {};
    }
    std::size_t winner = 0;
    for (std::size_t i = 1; i < members.size(); ++i) {
      if (members[i].priority() > members[winner].priority()) {
        winner = i;
      }
    }
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (i != winner) {
        members[i].trace.inhibited_by = static_cast<int>(winner);
        members[i].trace.reason = "suppressed";
      }
    }
    const elsie::MotorCommand command = members[winner].respond().command;
    members[winner].trace.weight = 1.0;
    members[winner].trace.share = 1.0;
    members[winner].trace.reason = "highest priority";
    return command;
  }
};

}  // namespace

ELSIE_COORDINATOR(ArbiterSuppression, "arbiter_suppression",
                  "Runs only the behaviour of highest priority; the first in the file wins a tie");
