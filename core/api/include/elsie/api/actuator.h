// An actuator: what a robot does besides moving. It shines, holds, speaks.
//
// A *command* is a plain struct that names its kind and lists its fields, like a reading:
//
//   struct LedCommand {
//     static constexpr const char* kind = "led";
//     elsie::Colour colour;
//     template <class Visitor> void visit(Visitor&& v) const { ... }
//   };
//
// A behaviour adds commands to its response: response.act(LedCommand{kRed}). Of the behaviours that
// command an actuator in a control period, one decides: see Coordinator::resolve(). Its command
// holds until the next one.
//
// Once every control period, after the decision, the simulator asks all actuators of a robot to
// carry out their commands. What they do has an effect on others from the next period on.
#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "elsie/api/component.h"
#include "elsie/api/disturbance.h"
#include "elsie/api/image.h"
#include "elsie/api/message.h"
#include "elsie/api/perception.h"
#include "elsie/api/registration.h"
#include "elsie/base/random.h"

namespace elsie {

/// How a message is sent.
struct Transmission {
  double range_m = 1.0;    // from the sender's place: who is farther away does not hear it
  double delay_s = 0.0;    // at least until the next control period
  double loss = 0.0;       // probability that a receiver does not hear it
  bool in_sight = false;   // only over a line of sight; then receivers know where the sender is
  bool tells_from = true;  // receivers know who the sender is
  /// Bytes that a message may have.
  std::size_t bandwidth = std::numeric_limits<std::size_t>::max();
};

/// What an actuator can do. Each effect is for one control period: an actuator repeats it for as
/// long as its command holds.
class Effects {
 public:
  /// Shines with this colour at the place of the actuator: light sensors and cameras see it.
  /// `intensity`: as that of a lamp; it must be finite and above 0.
  virtual void shine(const Colour& colour, double intensity) = 0;
  /// Sends a message, to the robot with the id `to` or, if that is empty, to all that hear it:
  /// robots with an actuator of the same plugin, which declares hears_messages(). Throws
  /// base::Error for a message to the robot itself.
  virtual void transmit(const std::shared_ptr<const AnyMessage>& message, const std::string& to,
                        const Transmission& how) = 0;
  /// Holds: takes the nearest dynamic obstacle or resource to be carried to a nest whose outline is
  /// within `reach_m` of the place of the actuator, seen from above, and keeps it for as long as
  /// this is repeated. OwnState::held has it from the next period on. A robot lets go when it is
  /// placed elsewhere, and when its battery is empty.
  virtual void hold(double reach_m) = 0;
  /// Adds this amount, once, to a field of the world at the place of the actuator: for a rate per
  /// second, times ActuatorContext::period_s. A negative amount takes away what is there. Throws
  /// base::Error if there is no such field, or the amount is not finite or larger than 1e12.
  virtual void deposit(std::string_view field, double amount) = 0;
  /// Takes energy from the battery, units per second; at least 0.
  virtual void draw_power(double units_per_s) = 0;

 protected:
  ~Effects() = default;
};

/// The instant at which an actuator carries out its command.
struct ActuatorContext {
  double time_s = 0.0;
  double period_s = 0.0;     // until the next time
  bool is_new = false;       // a behaviour has given the command in this period
  Frame frame;               // the actuator in the world
  const Mounting* mounting;  // the actuator on the robot
  const OwnState& self;      // as in Perception
  Random* random = nullptr;  // its own stream
  Effects* robot = nullptr;
};

/// An actuator without the type of its commands. Derive from ActuatorOf<Command> instead.
class Actuator : public Disturbable {
 public:
  /// As Sensor::equipped(); `mounting` is the actuator on its robot.
  virtual void equipped(const Mounting& /*mounting*/) {}
  /// Throws base::Error with a sentence for a command that is not finite, or whose arrays have
  /// other sizes than those of blank().
  virtual void check_command(const void* command) const = 0;
  /// Takes a command of its kind, which was checked.
  virtual void take(const void* command) = 0;
  /// Carries out the present command.
  virtual void carry_out(const ActuatorContext& now) = 0;
  const char* value_name() const final { return "command"; }
};

/// An actuator that takes commands of one kind. The command before the first one is blank().
template <class Command>
class ActuatorOf : public Holding<Actuator, Command> {
 public:
  using CommandType = Command;

  /// Carries out a command. Called once in every control period, also for a command that holds.
  virtual void act(const Command& command, const ActuatorContext& now) = 0;

  void check_command(const void* command) const final {
    this->check(*static_cast<const Command*>(command));
  }
  void take(const void* command) final { this->in_work() = *static_cast<const Command*>(command); }
  void carry_out(const ActuatorContext& now) final { act(this->current(), now); }
};

/// Robots with the actuator hear what others send with such ones.
inline auto hears_messages() {
  return [](Declaration& declaration) { declaration.hears_messages = true; };
}

/// Makes an actuator class a plugin; see ELSIE_BEHAVIOR. The kind of commands comes from its base
/// class.
#define ELSIE_ACTUATOR(Class, ...)                                          \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::actuator, Class, __VA_ARGS__, \
                         ::elsie::takes<Class::CommandType>())

}  // namespace elsie
