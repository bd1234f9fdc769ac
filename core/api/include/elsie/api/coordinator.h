// A coordinator decides which behaviours run in a step and combines their wishes into one motion.
//
// Each robot has one. It gets its members in the order of the world file and asks those that it
// needs. A member's behaviour runs at most once a step, when it is first asked; a behaviour that is
// not asked does not run and costs nothing.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "elsie/api/behavior.h"
#include "elsie/api/component.h"
#include "elsie/api/graph.h"
#include "elsie/api/motion.h"
#include "elsie/api/perception.h"
#include "elsie/api/registration.h"

namespace elsie {

/// What a coordinator noted about one of its behaviours in one step: a row of the trace. The member
/// fills asked, command, activation, strength, status and time when it is asked; the coordinator
/// fills the rest.
struct TraceRow {
  bool asked = false;               // whether respond() ran in this step
  Motion command;                   // the behaviour's wish
  double activation = 0.0;          // as the behaviour reported it
  double strength = 0.0;            // as the behaviour reported it
  Status status = Status::running;  // as the behaviour reported it
  double weight = 0.0;              // the factor of its command in the sum; negative only for a
                                    // negative priority
  double share = 0.0;               // its part in the result, in [0, 1]
  int inhibited_by = -1;            // index of the member that silenced it; -1: none
  double time_s = 0.0;  // duration of respond() on the clock; 0 unless it is being measured
  std::string reason;   // one or two words: "highest priority"
};

/// One behaviour as its coordinator sees it.
class Member {
 public:
  /// Runs the behaviours for the simulator: it measures time, checks the answers, and names the
  /// plugin that throws.
  class Runner {
   public:
    virtual const Response& run(Member& member) = 0;
    virtual void rate(Member& member, std::span<const Motion> candidates,
                      std::span<double> desirability) = 0;
    virtual CommandSets command_sets(Member& member) = 0;
    virtual std::span<const PublishedNumber> published(const Member& member) const = 0;
    virtual double published(const Member& member, std::size_t number) const = 0;

   protected:
    ~Runner() = default;
  };

  Member(std::string_view name, double priority, Runner& runner)
      : name_(name), priority_(priority), runner_(&runner) {}
  Member(Member&&) = default;
  Member& operator=(Member&&) = default;

  /// Its id in the world file: the plugin's name, unless the file gives another.
  std::string_view name() const { return name_; }
  /// As the user set it; default 1.
  double priority() const { return priority_; }
  /// The behaviour's answer in this step. The behaviour runs on the first call of a step only.
  const Response& respond() {
    if (!response_) {
      response_ = &runner_->run(*this);
      trace.asked = true;
      trace.command = response_->command;
      trace.activation = response_->activation;
      trace.strength = response_->strength;
      trace.status = response_->status;
    }
    return *response_;
  }
  /// How desirable each candidate is to the behaviour, in [0, 1]: Behavior::rate(). Both spans have
  /// the same size.
  void rate(std::span<const Motion> candidates, std::span<double> desirability) {
    respond();
    runner_->rate(*this, candidates, desirability);
  }
  /// The behaviour's fuzzy sets: Behavior::command_sets().
  CommandSets command_sets() {
    respond();
    return runner_->command_sets(*this);
  }

  /// The numbers that the behaviour's declaration publishes.
  std::span<const PublishedNumber> published() const { return runner_->published(*this); }
  /// One of them as it is now, by its index; NaN: there is none.
  double published(std::size_t number) const { return runner_->published(*this, number); }

  TraceRow trace;

  /// Forgets the last answer. The simulator calls this before each decision.
  void begin_step() {
    response_ = nullptr;
    std::string text = std::move(trace.reason);  // keeps its memory for the next reason
    text.clear();
    trace = {};
    trace.reason = std::move(text);
  }

 private:
  std::string_view name_;
  double priority_;
  Runner* runner_;
  const Response* response_ = nullptr;
};

/// A behaviour's command to an actuator, in one control period.
struct ActuatorWish {
  const Member* member;
  const Act* act;
};

/// The wish with the greatest priority, of equals the first: its index.
std::size_t greatest_priority(std::span<const ActuatorWish> wishes);

class Coordinator : public Component {
 public:
  /// Called after configured(), when the robot is complete, and again when the members change; see
  /// Behavior::equipped(). Do not ask the members here.
  virtual void equipped(std::span<const Member> members, const Perception& example);

  /// The command for this control period. `members` is in file order and may be empty: return zero
  /// then. Fill the weight, share and reason of each member's trace; the rows are cleared before
  /// the call.
  virtual Motion coordinate(std::span<Member> members, const Perception& now) = 0;

  /// Which command an actuator gets: an index into `wishes`, or their number for none of them.
  /// Called after coordinate() for each actuator that several behaviours command: behaviours that
  /// were asked and are not inhibited, then those that only act, each in file order. The default is
  /// greatest_priority().
  virtual std::size_t resolve(std::string_view actuator, std::span<const ActuatorWish> wishes);

  /// How it stands after coordinate(), for a coordinator inside a behaviour; the default is
  /// running.
  virtual Status status() const { return Status::running; }

  /// What it shows of its inside; the default is nothing. Called after equipped().
  virtual Graph graph() const { return {}; }
  /// What the nodes of the graph are in this control period. All are dark before.
  virtual void light(std::span<NodeState> /*nodes*/) const {}

  /// How good each candidate command would be for the members together, in [0, 1]; for a
  /// coordinator inside a behaviour. `given` is the answer of coordinate() in this step. The
  /// default is a Gaussian around the given command, as in Behavior::rate().
  virtual void rate(std::span<Member> members, const Perception& now, const Motion& given,
                    std::span<const Motion> candidates, std::span<double> desirability);

  /// The combined wishes of the members as fuzzy sets, before defuzzification. The default is a
  /// triangle around the given command, as in Behavior::command_sets().
  virtual CommandSets command_sets(std::span<Member> members, const Perception& now,
                                   const Motion& given);
};

/// Makes a coordinator class a plugin; see ELSIE_BEHAVIOR.
#define ELSIE_COORDINATOR(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::coordinator, Class, __VA_ARGS__)

}  // namespace elsie
