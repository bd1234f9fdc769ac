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
    elsie::RayQuery ray = ray_of(now);
    now.world->cast_rays({&ray, 1});
    return reading_of(ray, now);
  }

  void update_all(std::span<const Update> all) override {
    constexpr std::size_t kMost = 16;  // rays in a query
    for (; !all.empty(); all = all.subspan(std::min(kMost, all.size()))) {
      const auto some = all.first(std::min(kMost, all.size()));
      std::array<elsie::RayQuery, kMost> rays;
      for (std::size_t i = 0; i < some.size(); ++i) {
        rays[i] = beam(some[i]).ray_of(some[i].now);
      }
      some.front().now.world->cast_rays(std::span(rays).first(some.size()));
      for (std::size_t i = 0; i < some.size(); ++i) {
        beam(some[i]).set_reading(beam(some[i]).reading_of(rays[i], some[i].now));
      }
    }
  }

 private:
  static BeamRange& beam(const Update& update) { return static_cast<BeamRange&>(*update.sensor); }

  elsie::RayQuery ray_of(const elsie::SensorContext& now) const {
    return {now.frame.origin, now.frame.forward, max_range};
  }

  elsie::RangeReading reading_of(const elsie::RayQuery& ray,
                                 const elsie::SensorContext& now) const {
    if (ray.distance_m > max_range) {
      return {max_range, max_range, false};
    }
    double measured = ray.distance_m;
    if (error > 0.0) {
      measured += now.random->normal(0.0, error * ray.distance_m);
    }
    if (error_m > 0.0) {
      measured += now.random->normal(0.0, error_m);
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
