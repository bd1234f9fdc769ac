// A behaviour: one small, complete reason to move.
//
// A behaviour maps what the robot senses at this instant to a motion and to events. It holds
// no model of the world and does not know which other behaviours run beside it; it may keep state
// of its own. What becomes of its command is for the robot's coordinator to decide: it may win, be
// blended with others', be suppressed, or not be asked for at all.
//
// Once every control period, for every robot:
//
// 1. sensors are read;
// 2. the coordinator asks its behaviours, in its own order, each at most once: respond();
// 3. of behaviours that answered, and only if its scheme needs it, it asks further: rate() and
//    command_sets(), which refer to the answer just given;
// 4. the robot's drive makes the motion that the coordinator commands, or the nearest that it can.
//
// A coordinator that picks one behaviour by a fixed priority runs that one only; so do not count
// calls to keep time: take `now.time_s()`.
//
// A whole plugin: see examples/ for ones that are built and run with the tests.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/component.h"
#include "elsie/api/event.h"
#include "elsie/api/motion.h"
#include "elsie/api/perception.h"
#include "elsie/api/registration.h"
#include "elsie/base/fuzzy_set.h"

namespace elsie {

/// A behaviour's answer. A bare Motion converts to one.
struct Response {
  Response() = default;
  Response(const Motion& wish) : command(wish) {}  // NOLINT(google-explicit-constructor)

  Motion command;
  /// How much the behaviour has to say now, in [0, 1]. Zero: not active; subsumption and action
  /// selection pass it over.
  double activation = 1.0;
  /// How firmly it stands by its command, in [0, 1], for coordinators that resolve by strength.
  double strength = 1.0;
  /// The same for each channel by itself, as factors of `strength`, in [0, 1]: a behaviour that
  /// only steers leaves the speed open, one that only brakes leaves the direction open.
  double speed_strength = 1.0;  // of the forward speed
  double lateral_strength = 1.0;
  double turn_strength = 1.0;
  /// Asks the simulator to charge the battery. Granted while the robot is at a charger of its team.
  bool charge = false;
  /// What the behaviour says has happened. Empty costs nothing.
  std::vector<Event> events;
};

/// Behaviours with a coordinator of their own, inside a behaviour: so coordination nests. What is
/// in it stands in the world file as <behaviors> and <coordinator> inside the behaviour's element;
/// the simulator makes it and runs it. See holds_behaviors() in declaration.h.
class Coordination {
 public:
  /// Asks the coordinator, which asks its behaviours: their command together. Its activation and
  /// strengths (as a whole and of each channel) are the means of theirs, weighted by their
  /// shares in the command. Events and charging that they ask for are seen to.
  virtual Response respond(const Perception& now) = 0;
  /// How good candidate commands are to all of them together, once respond() was called in this
  /// step: Coordinator::rate().
  virtual void rate(std::span<const Motion> candidates, std::span<double> desirability) = 0;
  /// Their wishes together as fuzzy sets, likewise: Coordinator::command_sets().
  virtual CommandSets command_sets() = 0;

 protected:
  ~Coordination() = default;
};

class Behavior : public Component {
 public:
  /// Called after configured(), when the robot is complete, and again while a run goes on, after a
  /// change of parameters or an edit of the robot: what is remembered should last then. `example`
  /// has every reading that the robot has, with values that mean nothing. What the robot is counts
  /// already: the body's measures, the team, whether it has a charger. Throw
  /// (std::invalid_argument, with a sentence) when the parameters do not fit the sensors.
  virtual void equipped(const Perception& example);

  /// The answer to what is perceived now. A finite motion; anything else ends the run and names the
  /// plugin. Behaviours that think in wheel rates say `now.self().wheels.motion({left, right})`.
  virtual Response respond(const Perception& now) = 0;

  /// How good each of the candidate commands would be to this behaviour now, each in [0, 1];
  /// `desirability` has the size of `candidates`. `given` is what respond() answered in this step
  /// to `now`. By default a bump around the given command: 1 at the command, exp(-(d / 5 rad/s)^2 /
  /// 2) at a distance d in the plane of wheel rates: WheelPair::distance_squared(). A lateral wish
  /// counts only if the drive has that channel.
  virtual void rate(const Perception& now, const Response& given,
                    std::span<const Motion> candidates, std::span<double> desirability) const;

  /// The wishes for each wheel as fuzzy sets, before defuzzification, and for the lateral speed if
  /// the drive has that channel. Behaviours that are fuzzy hand over their own; the default is a
  /// triangle around the given command, of half width 5 rad/s, for the lateral speed that of a
  /// wheel at this rate.
  virtual CommandSets command_sets(const Perception& now, const Response& given) const;
};

/// Makes a behaviour class a plugin:
///   ELSIE_BEHAVIOR(Class, "name", "one line that says what it does", items...)
/// Items: elsie::parameter(), elsie::elements(), elsie::holds_behaviors(), elsie::needs<Reading>(),
/// elsie::raises(), elsie::version(); see
/// declaration.h.
#define ELSIE_BEHAVIOR(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::behavior, Class, __VA_ARGS__)

}  // namespace elsie
