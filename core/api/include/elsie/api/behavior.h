// A behaviour: one small, complete reason to move.
//
// A behaviour maps what the robot senses at this instant to a motion and to events. It holds no
// model of the world and does not know which other behaviours run; it may keep state of its own.
// The robot's coordinator decides about its command: the command may win, be blended with others,
// be suppressed, or not be requested at all.
//
// Once every control period, for every robot:
//
// 1. sensors are read;
// 2. the coordinator asks its behaviours, in its own order, each at most once: respond();
// 3. if its scheme needs more, it also calls rate() and command_sets() of behaviours that answered;
//    both refer to the answer just given;
// 4. the robot's drive makes the commanded motion, or the nearest one that it can make.
//
// A coordinator that picks one behaviour by a fixed priority runs only that one. So do not count
// calls to measure time: use `now.time_s()`.
//
// examples/ has complete plugins, which the tests build and run.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/event.h"
#include "elsie/api/motion.h"
#include "elsie/api/perception.h"
#include "elsie/api/registration.h"
#include "elsie/base/fuzzy_set.h"

namespace elsie {

/// Numbers of a command by the names that its visit() lists: {"red", 1.0}, {"angles.2", 0.5}.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

/// A command to an actuator of the own robot; see actuator.h.
class Act {
 public:
  template <class Command>
  Act(std::string actuator, Command command)
      : actuator_(std::move(actuator)),
        kind_(ReadingKind::of<Command>()),
        command_(std::make_shared<const Command>(std::move(command))) {}
  /// The same for who does not know the struct: a blank command of this kind, or of whatever kind
  /// the actuator takes if that is empty, with these numbers. The simulator makes it.
  Act(std::string actuator, std::string kind, NamedNumbers numbers)
      : actuator_(std::move(actuator)),
        named_(std::make_shared<const Named>(Named{std::move(kind), std::move(numbers)})) {
    kind_.name = named_->kind.c_str();
  }
  /// A command for this actuator, made by the simulator.
  Act(std::string actuator, const ReadingKind& kind, std::shared_ptr<const void> command)
      : actuator_(std::move(actuator)), kind_(kind), command_(std::move(command)) {}

  /// The actuator's id in the world file; empty: the first that takes such commands.
  const std::string& actuator() const { return actuator_; }
  const ReadingKind& kind() const { return kind_; }
  /// The struct of the command; null: it is given by its numbers().
  const void* command() const { return command_.get(); }
  const NamedNumbers& numbers() const { return named_->numbers; }
  /// The ids of the behaviours that hold the one that gave it, and its own: "forage/grip". The
  /// simulator sets it.
  const std::string& by() const { return by_; }
  /// The same act, given inside this behaviour.
  Act within(std::string_view behavior) const {
    Act act = *this;
    act.by_ = std::string(behavior) + (by_.empty() ? "" : "/") + by_;
    return act;
  }

 private:
  struct Named {
    std::string kind;
    NamedNumbers numbers;
  };

  std::string actuator_;
  ReadingKind kind_;
  std::shared_ptr<const void> command_;
  std::shared_ptr<const Named> named_{};
  std::string by_{};
};

/// How what a behaviour does stands, for coordinators that wait for its end. Whatever has no end is
/// always running.
enum class Status { running, success, failure };

/// A behaviour's answer. A bare Motion converts to one.
struct Response {
  Response() = default;
  Response(const Motion& wish) : command(wish) {}  // NOLINT(google-explicit-constructor)

  Motion command;
  /// How relevant the behaviour is now, in [0, 1]. Zero: not active; subsumption and action
  /// selection skip it.
  double activation = 1.0;
  /// The strength of its command, in [0, 1], for coordinators that resolve conflicts by strength.
  double strength = 1.0;
  /// The same for each channel, as factors of `strength`, in [0, 1]: a behaviour that only steers
  /// leaves the speed open, one that only brakes leaves the direction open.
  double speed_strength = 1.0;  // of the forward speed
  double lateral_strength = 1.0;
  double turn_strength = 1.0;
  /// The direction, from the heading, along which the motion matters to it: motions that differ
  /// only across it are equally good. None: all that it commands matters.
  std::optional<double> matters_rad{};
  Status status = Status::running;
  /// Asks the simulator to charge the battery. Works only at a charger of its team.
  bool charge = false;
  /// The events that the behaviour raises. An empty list costs nothing.
  std::vector<Event> events;
  /// Its commands to actuators. An empty list costs nothing.
  std::vector<Act> acts;

  /// Commands the first actuator that takes such commands: act(LedCommand{kRed}). What the robot
  /// has none for ends the run.
  template <class Command>
  void act(Command wanted) {
    acts.emplace_back("", std::move(wanted));
  }
  /// Commands the actuator with this id.
  template <class Command>
  void act(std::string actuator, Command wanted) {
    acts.emplace_back(std::move(actuator), std::move(wanted));
  }
  /// Says a message by the first actuator that sends messages, or the one with the id `by`: to the
  /// robot with the id `to`, or to all that hear it. Throws std::invalid_argument if a number of it
  /// is not finite.
  template <class Content>
  void say(Content content, std::string to = "", std::string by = "") {
    act(std::move(by),
        SayCommand{std::make_shared<const AnyMessage>(AnyMessage(std::move(content))),
                   std::move(to)});
  }
};

/// Behaviours with a coordinator of their own, inside a behaviour (nested coordination). The world
/// file lists them as <behaviors> and <coordinator> inside the behaviour's element; the simulator
/// makes and runs them. See holds_behaviors() in declaration_items.h.
class Coordination {
 public:
  /// Asks the coordinator, which asks its behaviours, and returns their combined command, with what
  /// the actuators are to do.
  /// Activation and strengths (overall and of each channel) are means weighted by the behaviours'
  /// shares in the command; the status is the coordinator's. The simulator handles their events and
  /// requests for charging.
  virtual Response respond(const Perception& now) = 0;
  /// How good candidate commands are for all of them together (Coordinator::rate()). Call respond()
  /// first in the same step.
  virtual void rate(std::span<const Motion> candidates, std::span<double> desirability) = 0;
  /// Their combined wishes as fuzzy sets (Coordinator::command_sets()), also after respond().
  virtual CommandSets command_sets() = 0;

 protected:
  ~Coordination() = default;
};

class Behavior : public Component {
 public:
  /// Called after configured(), when the robot is complete. Called again during a run after a
  /// change of parameters or an edit of the robot; keep remembered state then. `example` has every
  /// reading that the robot has, with meaningless values. Facts about the robot are valid: the size
  /// of the body, the team, whether it has a charger. Throw (std::invalid_argument, with a
  /// sentence) when the parameters do not fit the sensors.
  virtual void equipped(const Perception& example);

  /// The answer to the present perception. A motion that is not finite ends the run and names the
  /// plugin. Behaviours that use wheel rates return `now.self().wheels.motion({left, right})`.
  virtual Response respond(const Perception& now) = 0;

  /// How good each candidate command would be for this behaviour now, in [0, 1]; `desirability` has
  /// the size of `candidates`. `given` is the answer of respond() to `now` in this step. The
  /// default is a Gaussian around the given command: exp(-(d / 5 rad/s)^2 / 2) at a distance d in
  /// the plane of wheel rates (WheelPair::distance_squared()). Lateral speed counts only if the
  /// drive has that channel.
  virtual void rate(const Perception& now, const Response& given,
                    std::span<const Motion> candidates, std::span<double> desirability) const;

  /// The wishes for each wheel as fuzzy sets, before defuzzification, and for the lateral speed if
  /// the drive has that channel. Fuzzy behaviours return their own sets. The default is a triangle
  /// around the given command with a half width of 5 rad/s; for the lateral speed, the rim speed of
  /// a wheel at that rate.
  virtual CommandSets command_sets(const Perception& now, const Response& given) const;
};

/// Makes a behaviour class a plugin:
///   ELSIE_BEHAVIOR(Class, "name", "one line that says what it does", items...)
/// Items: elsie::parameter(), elsie::elements(), elsie::holds_behaviors(), elsie::needs<Reading>(),
/// elsie::commands<Command>(), elsie::hears<Message>(), elsie::only_acts(), elsie::raises(),
/// elsie::version(); see declaration_items.h.
#define ELSIE_BEHAVIOR(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::behavior, Class, __VA_ARGS__)

}  // namespace elsie
