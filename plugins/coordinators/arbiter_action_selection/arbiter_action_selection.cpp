// Action selection: the most active behaviour decides, and may keep deciding for a while when
// others become nearly as active.
#include <cstddef>
#include <optional>
#include <string>

#include <elsie/api/remember.h>

#include "winner.h"

namespace {

class ArbiterActionSelection final : public WinnerTakesAll, public elsie::Remembers {
 public:
  double threshold = 0.0;
  double margin = 0.0;
  double hold = 0.0;
  bool by_priority = false;

  void reset(elsie::Random&) override {
    decided_.clear();
    since_s_ = 0.0;
  }
  void remember(elsie::Memory& memory) override {
    memory("winner", decided_);
    memory("since_s", since_s_);
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    std::optional<std::size_t> best, last;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (members[i].name() == decided_) {
        last = i;
      }
      const double level = level_of(members[i]);
      if (level > threshold && (!best || level > level_of(members[*best]))) {
        best = i;
      }
    }
    if (!best) {
      decided_.clear();
      return nobody(members, "nobody is active");
    }

    const bool challenged = last && last != best && level_of(members[*last]) > threshold;
    const char* reason = "highest activation";
    std::size_t winner = *best;
    if (challenged && now.time_s() - since_s_ < hold - 1e-9) {
      winner = *last;
      reason = "kept: minimum time";
    } else if (challenged && margin > 0.0 &&
               level_of(members[*best]) <= level_of(members[*last]) + margin) {
      winner = *last;
      reason = "kept: margin";
    } else if (last != best) {
      since_s_ = now.time_s();
    }
    decided_ = members[winner].name();
    const elsie::Motion command = let_decide(members, winner, reason, "lower activation");
    for (elsie::Member& member : members) {
      if (&member != &members[winner]) {
        note_loser(member, level_of(members[winner]));
      }
    }
    return command;
  }

 private:
  /// The level at which a behaviour competes. One that its priority excludes is not asked.
  double level_of(elsie::Member& member) const {
    if (!by_priority) {
      return member.respond().activation;
    }
    return member.priority() > 0.0 ? member.respond().activation * member.priority() : 0.0;
  }

  void note_loser(elsie::Member& member, double winning_level) const {
    const double level = level_of(member);
    if (by_priority && !(member.priority() > 0.0)) {
      member.trace.reason = "priority not above zero";
    } else if (level <= threshold) {
      member.trace.reason = "not active";
      member.trace.inhibited_by = -1;
    } else if (level == winning_level) {
      member.trace.reason = "equally active";
    } else if (level > winning_level) {
      member.trace.reason = "higher, but must wait";
    }
  }

  std::string decided_;   // who won last: places change when others come and go
  double since_s_ = 0.0;  // when it took over
};

}  // namespace

ELSIE_COORDINATOR(
    ArbiterActionSelection, "arbiter_action_selection",
    "The behaviour with the highest activation decides; the first in the file wins a tie",
    elsie::parameter("threshold", &ArbiterActionSelection::threshold,
                     {.min = 0, .meaning = "only behaviours more active than this take part"}),
    elsie::parameter("margin", &ArbiterActionSelection::margin,
                     {.min = 0,
                      .meaning = "how much more active another behaviour must be to take over"}),
    elsie::parameter(
        "hold", &ArbiterActionSelection::hold,
        {.unit = "s",
         .min = 0,
         .meaning = "the least time for which a behaviour decides, if it stays active"}),
    elsie::parameter("by_priority", &ArbiterActionSelection::by_priority,
                     {.meaning = "whether activations are multiplied by priorities"}));
