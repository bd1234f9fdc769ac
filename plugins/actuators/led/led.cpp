// A lamp on the robot: light sensors see how bright it is, cameras its colour.
#include <algorithm>

#include <elsie/api/actuator.h>
#include <elsie/commands/led.h>

namespace {

class Led final : public elsie::ActuatorOf<elsie::LedCommand> {
 public:
  double intensity = 0.1;
  double power = 0.0;

  void act(const elsie::LedCommand& command, const elsie::ActuatorContext& now) override {
    const double brightness = std::clamp(command.brightness, 0.0, 1.0);
    now.robot->draw_power(power * brightness);
    const double shines = intensity * brightness;
    if (shines > 0.0) now.robot->shine(command.colour, shines);
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (current().brightness > 0.0) sketch.circle(elsie::SketchRole::field, {}, 0.02);
  }
};

}  // namespace

ELSIE_ACTUATOR(Led, "led", "A lamp on the robot, which light sensors and cameras see",
               elsie::parameter("intensity", &Led::intensity,
                                {.above = 0,
                                 .max = 1e6,
                                 .meaning = "at full brightness, as that of a lamp of the world"}),
               elsie::parameter("power", &Led::power,
                                {.unit = "units/s",
                                 .min = 0,
                                 .max = 1e12,
                                 .meaning = "the energy that it uses at full brightness"}));
