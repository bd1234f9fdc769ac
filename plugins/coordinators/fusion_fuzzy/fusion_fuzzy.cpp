// Fuzzy command fusion: the behaviours' wishes are combined as fuzzy sets and defuzzified last.
#include "set_fusion.h"

namespace {

class FusionFuzzy final : public SetFusion {
 public:
  FusionFuzzy() : SetFusion("scale", "scale") {}

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    weigh(members, activation_rule(), "");
    return fuse(members, now);
  }
};

}  // namespace

ELSIE_COORDINATOR(FusionFuzzy, "fusion_fuzzy",
                  "Puts the behaviours' fuzzy sets together and defuzzifies last",
                  elsie::parameter("combination", &FusionFuzzy::combination, combination_facts()),
                  elsie::parameter("weighting", &FusionFuzzy::weighting, weighting_facts()),
                  elsie::parameter("defuzzification", &FusionFuzzy::defuzzification,
                                   defuzzification_facts()),
                  elsie::parameter("conflict", &FusionFuzzy::conflict, conflict_facts()),
                  elsie::parameter("activation", &FusionFuzzy::activation, activation_facts()));
