// Arbitration with learned priorities: the behaviour with the largest output of the network
// decides, and only that one runs, unless all are asked.
#include <algorithm>
#include <string>

#include "priority_network.h"
#include "winner.h"

namespace {

class ArbiterNeuralNetwork final : public WithPriorityNetwork<WinnerTakesAll> {
 public:
  std::string ask = "winner";

  void configured() override {
    WithPriorityNetwork::configured();
    asks_all_ = ask == "all";
  }

  elsie::Motion coordinate(std::span<elsie::Member> members,
                           const elsie::Perception& now) override {
    if (members.empty()) {
      return nobody(members, "");
    }
    for (elsie::Member& member : members) {
      if (asks_all_) member.respond();
    }
    const std::span<const double> priority = priorities(now);
    // The first of equally large ones.
    const auto winner = std::max_element(priority.begin(), priority.end()) - priority.begin();
    const elsie::Motion command = let_decide(members, static_cast<std::size_t>(winner),
                                             "largest priority", "smaller priority");
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i].trace.weight = priority[i];
    }
    return command;
  }

 private:
  bool asks_all_ = false;
};

}  // namespace

ELSIE_COORDINATOR(ArbiterNeuralNetwork, "arbiter_neural_network",
                  "Lets the behaviour decide to which a neural network gives the largest priority; "
                  "the first in the file wins a tie",
                  elsie::needs<elsie::RangeReading>(),
                  elsie::parameter("ask", &ArbiterNeuralNetwork::ask,
                                   {.choices = {"winner", "all"},
                                    .meaning = "`winner`: the others do not run; `all`: every "
                                               "behaviour runs in each step, and the winner's "
                                               "command counts"}),
                  PRIORITY_NETWORK_PARAMETERS);
