// A gripper: it takes what is near it, and carries it as a part of the robot.
#include <elsie/api/actuator.h>
#include <elsie/commands/gripper.h>

namespace {

class Gripper final : public elsie::ActuatorOf<elsie::GripCommand> {
 public:
  double reach = 0.02;
  double power = 0.0;

  void act(const elsie::GripCommand& command, const elsie::ActuatorContext& now) override {
    if (!command.closed) return;
    now.robot->hold(reach);
    now.robot->draw_power(power);
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (current().closed) sketch.circle(elsie::SketchRole::field, {}, reach);
  }
};

}  // namespace

ELSIE_ACTUATOR(Gripper, "gripper",
               "Takes a box or resource that is near it, and carries it until it opens",
               elsie::parameter("reach", &Gripper::reach,
                                {.unit = "m",
                                 .min = 0,
                                 .max = 10,
                                 .meaning = "from its place to the outline of what it takes, seen "
                                            "from above"}),
               elsie::parameter("power", &Gripper::power,
                                {.unit = "units/s",
                                 .min = 0,
                                 .max = 1e12,
                                 .meaning = "the energy that it uses while it is closed"}));
