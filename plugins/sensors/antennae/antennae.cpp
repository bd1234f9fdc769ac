// Antennae: they sense a field of the world at places beside each other, as the two antennae of an
// ant sense its trail.
#include <cstddef>
#include <string>

#include <elsie/api/sensor.h>
#include <elsie/readings/antennae.h>

namespace {

class Antennae final : public elsie::SensorOf<elsie::AntennaeReading> {
 public:
  std::string field = "pheromone";
  int tips = 2;
  double width = 0.06;

  elsie::AntennaeReading blank() const override {
    elsie::AntennaeReading reading;
    describe(reading);
    reading.values.assign(static_cast<std::size_t>(tips), 0.0);
    return reading;
  }

  void sense_into(const elsie::SensorContext& now, elsie::AntennaeReading& reading) override {
    describe(reading);
    for (std::size_t i = 0; i < reading.values.size(); ++i) {
      const elsie::Vector3 tip = now.frame.origin + reading.offset_m(i) * now.frame.left;
      reading.values[i] = now.world->field(field, {tip.x, tip.y});
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    const elsie::AntennaeReading& reading = current();
    for (std::size_t i = 0; i < reading.values.size(); ++i) {
      sketch.point(elsie::SketchRole::field, {0.0, reading.offset_m(i), 0.0});
    }
  }

 private:
  void describe(elsie::AntennaeReading& reading) const {
    reading.first_m = tips > 1 ? 0.5 * width : 0.0;
    reading.step_m = tips > 1 ? width / (tips - 1) : 0.0;
  }
};

}  // namespace

ELSIE_SENSOR(Antennae, "antennae", "Sense a field of the world at places beside each other",
             elsie::names_field("field"),
             elsie::parameter("field", &Antennae::field,
                              {.meaning = "the id of the field", .live = false}),
             elsie::parameter("tips", &Antennae::tips,
                              {.min = 1,
                               .max = 1000,
                               .meaning = "number of places, evenly beside each other",
                               .live = false}),
             elsie::parameter("width", &Antennae::width,
                              {.unit = "m",
                               .above = 0,
                               .max = 100,
                               .meaning = "from the tip on the left to the tip on the right"}));
