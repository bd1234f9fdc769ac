// @name@: what it does, in a sentence; and a behaviour that commands it, in the same library. An actuator
// alone needs no behaviour: remove it here, in the test and in the world.
#include <cmath>

#include <elsie/api/actuator.h>
#include <elsie/api/behavior.h>

#include "@name@_command.h"

class @Class@ final : public elsie::ActuatorOf<@Class@Command> {
 public:
  // Parameters of the world file. Their defaults are set only here.
  double intensity = 0.5;

  // Called in every control period with the command that holds. `now.robot` lists what an actuator can do:
  // elsie/api/actuator.h.
  void act(const @Class@Command& command, const elsie::ActuatorContext& now) override {
    if (command.on) now.robot->shine({255, 200, 0}, intensity);
  }

  // What pictures, recordings and the window draw of it.
  void sketch(elsie::Sketch& sketch) const override {
    if (current().on) sketch.circle(elsie::SketchRole::field, {}, 0.03);
  }
};

ELSIE_ACTUATOR(@Class@, "@name@", "Shines while it is on",
               elsie::parameter("intensity", &@Class@::intensity,
                                {.above = 0, .max = 1000, .meaning = "as that of a lamp of the world"}));

// Switches it on and off; it never moves the robot.
class Use@Class@ final : public elsie::Behavior {
 public:
  double period = 1.0;  // s

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::Response response;
    response.act(@Class@Command{std::fmod(now.time_s(), period) < 0.5 * period});
    return response;
  }
};

ELSIE_BEHAVIOR(Use@Class@, "use_@name@", "Switches it on and off", elsie::only_acts(),
               elsie::commands<@Class@Command>(),
               elsie::parameter("period", &Use@Class@::period,
                                {.unit = "s", .above = 0, .max = 1000, .meaning = "from on to on"}));
