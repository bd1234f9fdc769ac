// Made-up behaviours, as a coordinator gets them.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/testing/situation.h"

namespace elsie::testing {

/// An answer of a behaviour that is active so far.
Response active(double activation, const MotorCommand& command);

/// A behaviour that answers as it is told.
struct MadeUp final : elsie::Behavior {
  Response respond(const Perception& now) override;
  void rate(const Response& given, std::span<const MotorCommand> candidates,
            std::span<double> desirability) const override;
  CommandSets command_sets(const Response& given) const override;

  Response answer;
  std::function<Response(const Perception&)> script;  // instead of it
  std::function<double(const MotorCommand&)> rating;  // instead of the default of elsie::Behavior
  std::optional<CommandSets> sets;                    // likewise
  int asked = 0;
};

///   Team team;
///   team.member("avoid", 2, active(0.5, {10, -10})).member("seek", 1, MotorCommand{20, 20});
///
/// Members stay where they are once a coordinator has been given the team: add them all first.
class Team final : private Member::Runner {
 public:
  using Script = std::function<Response(const Perception&)>;

  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// A behaviour that always answers the same.
  Team& member(const std::string& name, double priority, Response answer);
  /// One that answers what the function says.
  Team& member(const std::string& name, double priority, Script script);

  // What the member added last says when it is asked further; else the defaults of elsie::Behavior.

  /// How good each command is to it, in [0, 1].
  Team& rating(std::function<double(const MotorCommand&)> rating);
  Team& sets(CommandSets sets);

  /// From one step to the next. Each member is asked again; what the coordinator noted is gone.
  Team& next_step();
  /// What members perceive when they are asked, until the next step. Must stay where it is.
  Team& perceive(const Situation& now);

  std::size_t size() const { return members_.size(); }
  std::span<Member> members() { return members_; }
  /// To be changed between steps.
  Response& answer(std::size_t i) { return slots_[i].behavior.answer; }
  /// What the coordinator noted about a member in this step. Throws std::invalid_argument for a
  /// name that nobody has.
  const TraceRow& trace(std::size_t i) const { return members_[i].trace; }
  const TraceRow& trace(const std::string& name) const { return members_[index_of(name)].trace; }
  std::string reason(std::size_t i) const { return members_[i].trace.reason; }
  /// How often it has been asked since it was made.
  int asked(std::size_t i) const { return slots_[i].behavior.asked; }
  int asked(const std::string& name) const { return slots_[index_of(name)].behavior.asked; }

 private:
  const Response& run(Member& member) override;
  void rate(Member& member, std::span<const MotorCommand> candidates,
            std::span<double> desirability) override;
  CommandSets command_sets(Member& member) override;

  struct Slot {
    std::string name;
    MadeUp behavior;
    Response last;
  };

  Slot& slot_of(const Member& member) {
    return slots_[static_cast<std::size_t>(&member - members_.data())];
  }
  std::size_t index_of(const std::string& name) const;

  std::deque<Slot> slots_;
  std::vector<Member> members_;
  Situation nothing_;
  const Situation* now_ = &nothing_;
};

}  // namespace elsie::testing
