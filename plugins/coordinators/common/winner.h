// Shared by arbiters in which one behaviour decides.
#pragma once

#include <algorithm>
#include <optional>

#include <elsie/api/coordinator.h>

/// Inside another behaviour, such an arbiter passes on the wishes of its winner: the winner's own
/// ratings and sets, not a bump around the command. Without a winner there is no wish: ratings of
/// zero, empty sets.
class WinnerTakesAll : public elsie::Coordinator {
 public:
  void rate(std::span<elsie::Member> members, const elsie::Perception& /*now*/,
            const elsie::Motion& /*given*/, std::span<const elsie::Motion> candidates,
            std::span<double> desirability) override {
    if (winner_) {
      members[*winner_].rate(candidates, desirability);
    } else {
      std::fill(desirability.begin(), desirability.end(), 0.0);
    }
  }

  elsie::CommandSets command_sets(std::span<elsie::Member> members,
                                  const elsie::Perception& /*now*/,
                                  const elsie::Motion& /*given*/) override {
    return winner_ ? members[*winner_].command_sets() : elsie::CommandSets{};
  }

 protected:
  /// Writes this reason to all traces: nobody decides in this step. Returns the zero command.
  elsie::Motion nobody(std::span<elsie::Member> members, const char* reason) {
    winner_.reset();
    for (elsie::Member& member : members) {
      member.trace.reason = reason;
    }
    return {};
  }

  /// Lets one member decide: writes all traces, and returns its command.
  elsie::Motion let_decide(std::span<elsie::Member> members, std::size_t winner, const char* won,
                           const char* lost) {
    winner_ = winner;
    for (std::size_t i = 0; i < members.size(); ++i) {
      if (i != winner) {
        members[i].trace.inhibited_by = static_cast<int>(winner);
        members[i].trace.reason = lost;
      }
    }
    const elsie::Motion command = members[winner].respond().command;
    members[winner].trace.weight = 1.0;
    members[winner].trace.share = 1.0;
    members[winner].trace.reason = won;
    return command;
  }

  std::optional<std::size_t> winner_;  // of the last decision
};
