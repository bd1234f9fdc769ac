// @name@: how it decides, in a sentence.
#include <elsie/api/coordinator.h>

class @Class@ final : public elsie::Coordinator {
 public:
  // A parameter of the world file. Its default is set only here.
  double margin = 0.1;

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& /*now*/) override {
    std::size_t winner = winner_ < members.size() ? winner_ : 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      // respond() runs the behaviour at most once in a step. Another one must be clearly more active
      // than the one that drives now.
      if (members[i].respond().activation > members[winner].respond().activation + margin) {
        winner = i;
      }
    }
    winner_ = winner;
    if (members.empty()) {
      return {};
    }
    for (elsie::Member& member : members) {
      member.trace.reason = "less active";
    }
    members[winner].trace.weight = members[winner].trace.share = 1.0;
    members[winner].trace.reason = "most active";
    return members[winner].respond().command;
  }

  void reset(elsie::Random& /*random*/) override { winner_ = 0; }

 private:
  std::size_t winner_ = 0;
};

ELSIE_COORDINATOR(@Class@, "@name@", "The most active behaviour drives",
                  elsie::parameter("margin", &@Class@::margin,
                                   {.min = 0, .max = 1,
                                    .meaning = "how much more active another one must be"}));
