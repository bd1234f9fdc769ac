// Suppression by fixed priority: the behaviour of highest priority runs, and no other.
#include "winner.h"

namespace {

class ArbiterSuppression final : public WinnerTakesAll {
 public:
  elsie::Motion coordinate(std::span<elsie::Member> members, const elsie::Perception&) override {
    if (members.empty()) {
      return nobody(members, "");
    }
    std::size_t winner = 0;
    for (std::size_t i = 1; i < members.size(); ++i) {
      if (members[i].priority() > members[winner].priority()) {
        winner = i;
      }
    }
    return let_decide(members, winner, "highest priority", "suppressed");
  }
};

}  // namespace

ELSIE_COORDINATOR(ArbiterSuppression, "arbiter_suppression",
                  "Runs only the behaviour of highest priority; the first in the file wins a tie");
