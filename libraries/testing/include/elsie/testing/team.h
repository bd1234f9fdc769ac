// Made-up behaviours for a coordinator.
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

/// The answer of an active behaviour.
Response active(double activation, const Motion& command);

/// The motion of a robot with the default body whose wheels turn at these rates, rad/s.
inline Motion wheels(double left, double right) { return WheelPair().motion({left, right}); }

/// A behaviour with made-up answers.
struct MadeUp final : elsie::Behavior {
  Response respond(const Perception& now) override;
  void rate(const Perception& now, const Response& given, std::span<const Motion> candidates,
            std::span<double> desirability) const override;
  CommandSets command_sets(const Perception& now, const Response& given) const override;

  Response answer;
  std::function<Response(const Perception&)> script;  // replaces `answer`
  std::function<double(const Motion&)> rating;        // replaces the default of elsie::Behavior
  std::optional<CommandSets> sets;                    // likewise
  int asked = 0;
};

///   Team team;
///   team.member("avoid", 2, active(0.5, wheels(10, -10))).member("seek", 1, wheels(20, 20));
///
/// Members stay in place once a coordinator has the team: add all of them first.
class Team final : private Member::Runner {
 public:
  using Script = std::function<Response(const Perception&)>;

  Team() = default;
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  /// Adds a behaviour with a constant answer.
  Team& member(const std::string& name, double priority, Response answer);
  /// Adds a behaviour that answers by the function.
  Team& member(const std::string& name, double priority, Script script);

  // Further answers of the last member; by default those of elsie::Behavior.

  /// Sets the function that rates how desirable a command is, in [0, 1].
  Team& rating(std::function<double(const Motion&)> rating);
  Team& sets(CommandSets sets);
  /// Adds a number that it publishes.
  Team& publishes(const std::string& name, std::function<double()> value);

  /// Begins the next step: each member is asked again, and the coordinator's notes are cleared.
  Team& next_step();
  /// Sets what members perceive until the next step. `now` must stay in place.
  Team& perceive(const Situation& now);

  std::size_t size() const { return members_.size(); }
  std::span<Member> members() { return members_; }
  const Member& member(const std::string& name) const { return members_[index_of(name)]; }
  /// May be changed between steps.
  Response& answer(std::size_t i) { return slots_[i].behavior.answer; }
  /// The coordinator's notes about a member in this step. Throws std::invalid_argument for an
  /// unknown name.
  const TraceRow& trace(std::size_t i) const { return members_[i].trace; }
  const TraceRow& trace(const std::string& name) const { return members_[index_of(name)].trace; }
  std::string reason(std::size_t i) const { return members_[i].trace.reason; }
  /// The number of times that the member has been asked so far.
  int asked(std::size_t i) const { return slots_[i].behavior.asked; }
  int asked(const std::string& name) const { return slots_[index_of(name)].behavior.asked; }

 private:
  const Response& run(Member& member) override;
  void rate(Member& member, std::span<const Motion> candidates,
            std::span<double> desirability) override;
  CommandSets command_sets(Member& member) override;
  std::span<const PublishedNumber> published(const Member& member) const override {
    return slot_of(member).published;
  }
  double published(const Member& member, std::size_t number) const override {
    const Slot& slot = slot_of(member);
    return slot.published.at(number).get(slot.behavior);
  }

  struct Slot {
    std::string name;
    MadeUp behavior;
    Response last;
    std::vector<PublishedNumber> published;
  };

  std::size_t place_of(const Member& member) const {
    return static_cast<std::size_t>(&member - members_.data());
  }
  Slot& slot_of(const Member& member) { return slots_[place_of(member)]; }
  const Slot& slot_of(const Member& member) const { return slots_[place_of(member)]; }
  std::size_t index_of(const std::string& name) const;

  std::deque<Slot> slots_;
  std::vector<Member> members_;
  Situation nothing_;
  const Situation* now_ = &nothing_;
};

}  // namespace elsie::testing
