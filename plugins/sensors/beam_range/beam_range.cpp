// A single beam: a laser, or a very narrow sonar.
#include <algorithm>
#include <array>
#include <span>

#include <elsie/api/sensor.h>

namespace {

class BeamRange final : public elsie::SensorOf<elsie::RangeReading> {
 public:
  double max_range = 1.0;
  double error = 0.0;
  double error_m = 0.0;

  elsie::RangeReading sense(const elsie::SensorContext& now) override {
    elsie::RayQuery ray{now.frame.origin, now.frame.forward, max_range};
    now.world->cast_rays({&ray, 1});
    return reading_of(ray, *now.random);
  }

  void update_all(const elsie::SensorBatch& all) override {
    constexpr std::size_t kMost = 16;  // rays in a query
    for (auto rest = all.sensors; !rest.empty(); rest = rest.subspan(std::min(kMost, rest.size()))) {
      const auto some = rest.first(std::min(kMost, rest.size()));
      std::array<elsie::RayQuery, kMost> rays;
      for (std::size_t i = 0; i < some.size(); ++i) {
        rays[i] = {some[i].origin(all.robot), some[i].forward(all.robot), beam(some[i]).max_range};
      }
      all.world->cast_rays(std::span(rays).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) {
        beam(some[i]).set_reading(beam(some[i]).reading_of(rays[i], *some[i].random));
      }
    }
  }

 private:
  static BeamRange& beam(const elsie::SensorBatch::Entry& each) {
    return static_cast<BeamRange&>(*each.sensor);
  }

  elsie::RangeReading reading_of(const elsie::RayQuery& ray, elsie::Random& random) const {
    if (ray.distance_m > max_range) {
      return {max_range, max_range, false};
    }
    double measured = ray.distance_m;
    if (error > 0.0) {
      measured += random.normal(0.0, error * ray.distance_m);
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
