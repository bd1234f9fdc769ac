// A single beam: a laser, or a very narrow sonar.
#include <algorithm>

#include <elsie/api/sensor.h>

namespace {

class BeamRange final : public elsie::SensorOf<elsie::RangeReading> {
 public:
  double max_range = 1.0;
  double error = 0.0;
  double error_m = 0.0;

  elsie::RangeReading blank() const override { return {max_range, max_range, false}; }

  elsie::RangeReading sense(const elsie::SensorContext& now) override {
    const auto distance = now.world->cast_ray(now.frame.origin, now.frame.forward, max_range);
    return reading_of(distance.value_or(elsie::RayQuery::kNothing), *now.random);
  }

  void update_all(const elsie::SensorBatch& all) override {
    for (std::size_t i = 0; i < all.sensors.size(); ++i) {
      const auto& each = all.sensors[i];
      all.rays[i] = {&each.place->frame, beam(each).max_range};
    }
    all.world->cast_rays(all.robot, all.rays);
    for (std::size_t i = 0; i < all.sensors.size(); ++i) {
      const auto& each = all.sensors[i];
      beam(each).set_reading(beam(each).reading_of(all.rays[i].distance_m, *each.random));
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    // Before the first reading, as far as it can look.
    const bool has_looked = current().max_range_m > 0.0;
    const elsie::Vector3 end{has_looked ? current().distance_m : max_range, 0.0, 0.0};
    sketch.line(elsie::SketchRole::range, {}, end);
    if (current().hit) sketch.point(elsie::SketchRole::hit, end);
  }

 private:
  static BeamRange& beam(const elsie::SensorBatch::Entry& each) {
    return static_cast<BeamRange&>(*each.sensor);
  }

  elsie::RangeReading reading_of(double distance_m, elsie::Random& random) const {
    if (distance_m > max_range) {
      return {max_range, max_range, false};
    }
    double measured = distance_m;
    if (error > 0.0) {
      measured += random.normal(0.0, error * distance_m);
    }
    if (error_m > 0.0) {
      measured += random.normal(0.0, error_m);
    }
    return {std::clamp(measured, 0.0, max_range), max_range, true};
  }
};

}  // namespace

ELSIE_SENSOR(
    BeamRange, "beam_range", "Measures the distance to the nearest surface along a ray",
    elsie::parameter(
        "max_range", &BeamRange::max_range,
        {.unit = "m", .above = 0, .meaning = "range; also the reading when nothing is nearer"}),
    elsie::parameter("error", &BeamRange::error,
                     {.min = 0,
                      .max = 1,
                      .meaning = "standard deviation of the noise, as a fraction of the distance"}),
    elsie::parameter(
        "error_m", &BeamRange::error_m,
        {.unit = "m",
         .min = 0,
         .meaning = "standard deviation of noise that does not depend on the distance"}));
