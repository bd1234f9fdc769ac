// Leaves a trail: deposits into a field of the world. One that evaporates is pheromone, one that
// stays is ink.
#include <algorithm>
#include <string>

#include <elsie/api/actuator.h>
#include <elsie/commands/pen.h>

namespace {

class Pen final : public elsie::ActuatorOf<elsie::PenCommand> {
 public:
  std::string field = "pheromone";
  double rate = 1.0;

  void act(const elsie::PenCommand& command, const elsie::ActuatorContext& now) override {
    const double flow = std::clamp(command.flow, 0.0, 1.0);
    if (flow > 0.0) now.robot->deposit(field, rate * flow * now.period_s);
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (current().flow > 0.0) sketch.point(elsie::SketchRole::field, {});
  }
};

}  // namespace

ELSIE_ACTUATOR(Pen, "pen", "Leaves a trail: deposits into a field of the world",
               elsie::names_field("field"),
               elsie::parameter("field", &Pen::field,
                                {.meaning = "the id of the field", .live = false}),
               elsie::parameter("rate", &Pen::rate,
                                {.unit = "units/s",
                                 .min = -1e9,
                                 .max = 1e9,
                                 .meaning = "what it deposits at full flow; below 0 it wipes away "
                                            "what is there"}));
