// Phototaxis: drives to where the light comes from (Grey Walter's Elsie, 1948).
#include <cmath>
#include <limits>

#include <elsie/api/behavior.h>
#include <elsie/readings/light.h>

namespace {

class SeekLight final : public elsie::Behavior {
 public:
  double speed = 0.2;
  double gain = 3.0;
  double least = 0.001;
  double enough = 0.9;

  void reset(elsie::Random&) override {
    bearing_rad_ = std::numeric_limits<double>::quiet_NaN();
    brightest_ = 0.0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    // The sum of the cells' directions, each as long as it is bright.
    double ahead = 0.0, left = 0.0, all = 0.0;
    brightest_ = 0.0;
    for (const auto& light : now.readings<elsie::LightReading>()) {
      for (std::size_t i = 0; i < light->values.size(); ++i) {
        const double part = light->values[i] / light->largest;
        const double bright = light->dark_is_large ? 1.0 - part : part;
        const double azimuth = light.azimuth_rad() + light->azimuth_rad(i);
        ahead += bright * std::cos(azimuth);
        left += bright * std::sin(azimuth);
        all += bright;
        brightest_ = std::max(brightest_, bright);
      }
    }
    elsie::Response response;
    // Cells all around that see the same tell no direction: what is left of the sum is rounding.
    constexpr double kRounding = 1e-9;
    if (brightest_ < least || std::hypot(ahead, left) < kRounding * all) {
      bearing_rad_ = std::numeric_limits<double>::quiet_NaN();
      response.activation = response.strength = 0.0;
      return response;
    }
    bearing_rad_ = std::atan2(left, ahead);
    if (brightest_ >= enough) return response;  // it has arrived, and stays
    response.command = {speed * std::max(0.0, std::cos(bearing_rad_)), 0.0, gain * bearing_rad_};
    return response;
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (std::isfinite(bearing_rad_)) {
      sketch.arrow(elsie::SketchRole::target, {},
                   {0.2 * std::cos(bearing_rad_), 0.2 * std::sin(bearing_rad_), 0.0});
    }
  }

  double bearing_rad_ = std::numeric_limits<double>::quiet_NaN();  // of the light; NaN: none
  double brightest_ = 0.0;
};

}  // namespace

ELSIE_BEHAVIOR(
    SeekLight, "seek_light", "Drives to where the light comes from",
    elsie::needs<elsie::LightReading>(),
    elsie::parameter("speed", &SeekLight::speed,
                     {.unit = "m/s", .min = 0, .max = 10, .meaning = "how fast, straight on"}),
    elsie::parameter("gain", &SeekLight::gain,
                     {.unit = "1/s",
                      .min = 0,
                      .max = 100,
                      .meaning = "rate of turn for each radian that the light is off"}),
    elsie::parameter("least", &SeekLight::least,
                     {.above = 0,
                      .max = 1,
                      .meaning = "it wants nothing if its brightest cell sees less, as a fraction "
                                 "of the largest value"}),
    elsie::parameter("enough", &SeekLight::enough,
                     {.above = 0,
                      .max = 1,
                      .meaning = "it stops where its brightest cell sees so "
                                 "much"}),
    elsie::publishes(
        "bearing", &SeekLight::bearing_rad_,
        {.unit = "rad",
         .meaning = "of the light, to the left; none: it is dark, or as bright on every side"}),
    elsie::publishes("brightest", &SeekLight::brightest_,
                     {.meaning = "what the brightest cell sees, as a fraction"}));
