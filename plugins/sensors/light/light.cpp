// Light cells: they see the lamps of the world and those on other robots, unless something hides
// them.
//
// d is the distance to a lamp of intensity I, theta the angle between it and the cell's axis:
//
// - generic: the sum of (I / d)^2, at most 1
// - footbot: the sum of exp(-2 d / I) (1 - 2 theta / pi), of lamps with d / I <= 2.5 and
//   theta <= pi / 2: the light sensor of the foot-bot in ARGoS, which has 24 cells
// - khepera: 500 in the dark, and the less the brighter: the ambient light of Khepera II with a
//   lamp of 50 W (K-Team's user manual), of lamps with theta <= pi / 2. Several lamps are as one at
//   the distance at which it is as bright as they are together.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <elsie/api/sensor.h>
#include <elsie/readings/light.h>

namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;
constexpr double kDark = 500.0;          // of Khepera
constexpr double kLeastDistance = 1e-3;  // m: nothing is nearer to a lamp than its own size

double generic(double distance_m, double intensity) {
  const double bright = intensity / distance_m;
  return bright * bright;
}

double footbot(double distance_m, double intensity, double theta) {
  const double far = distance_m / intensity;
  if (far > 2.5 || theta > kRightAngle) return 0.0;
  return std::exp(-2.0 * far) * (1.0 - theta / kRightAngle);
}

/// Khepera's value at such a distance from its lamp.
double khepera(double distance_m) {
  struct Point {
    double distance_m, value;
  };
  static constexpr Point kTable[] = {{0.075, 75}, {0.1, 100}, {0.2, 250}, {0.4, 375}, {0.9, 450}};
  if (distance_m <= kTable[0].distance_m) return kTable[0].value;
  for (std::size_t i = 1; i < std::size(kTable); ++i) {
    if (distance_m > kTable[i].distance_m) continue;
    const Point &a = kTable[i - 1], &b = kTable[i];
    return a.value +
           (distance_m - a.distance_m) / (b.distance_m - a.distance_m) * (b.value - a.value);
  }
  // Beyond the table, what is missing to dark falls with the square of the distance.
  const Point& last = kTable[std::size(kTable) - 1];
  const double part = last.distance_m / distance_m;
  return kDark - (kDark - last.value) * part * part;
}

class Light final : public elsie::SensorOf<elsie::LightReading> {
 public:
  int cells = 1;
  double fov_deg = 360.0;
  std::string law = "generic";
  double led_range = 2.0;

  elsie::LightReading blank() const override {
    elsie::LightReading reading;
    describe(reading);
    reading.values.assign(static_cast<std::size_t>(cells), reading.dark_is_large ? kDark : 0.0);
    return reading;
  }

  void describe(elsie::LightReading& reading) const {
    reading.dark_is_large = law == "khepera";
    reading.largest = law == "khepera" ? kDark : 1.0;
    const double fov = elsie::radians(fov_deg);
    const bool is_round = fov_deg >= 360.0;
    reading.step_rad = is_round ? fov / cells : cells > 1 ? fov / (cells - 1) : 0.0;
    reading.first_rad = cells == 1 ? 0.0 : is_round ? 0.5 * (fov - reading.step_rad) : 0.5 * fov;
  }

  void sense_into(const elsie::SensorContext& now, elsie::LightReading& reading) override {
    describe(reading);
    lights_.clear();
    for (const elsie::LampView& lamp : now.world->lamps()) see(lamp, now);
    leds_.clear();
    if (led_range > 0.0) now.world->lights_within(led_range, leds_);
    for (const elsie::LampView& led : leds_) see(led, now);
    for (std::size_t i = 0; i < reading.values.size(); ++i) {
      const double azimuth = reading.azimuth_rad(i);
      const elsie::Vector3 axis = now.frame.direction({std::cos(azimuth), std::sin(azimuth), 0.0});
      reading.values[i] = value_along(axis);
    }
  }

  void sketch(elsie::Sketch& sketch) const override {
    constexpr double kLongest = 0.2;  // m
    const elsie::LightReading& reading = current();
    for (std::size_t i = 0; i < reading.values.size(); ++i) {
      const double part = reading.values[i] / reading.largest;
      const double length = kLongest * (reading.dark_is_large ? 1.0 - part : part);
      const double azimuth = reading.azimuth_rad(i);
      sketch.line(elsie::SketchRole::field, {},
                  {length * std::cos(azimuth), length * std::sin(azimuth), 0.0});
    }
  }

 private:
  /// A lamp that is not hidden.
  struct Bright {
    double distance_m;
    double intensity;
    elsie::Vector3 direction;
  };

  void see(const elsie::LampView& lamp, const elsie::SensorContext& now) {
    if (!now.world->is_open(now.frame.origin, lamp.place)) return;
    const elsie::Vector3 way = lamp.place - now.frame.origin;
    const double far = std::max(kLeastDistance, std::sqrt(elsie::dot(way, way)));
    lights_.push_back({far, lamp.intensity, (1.0 / far) * way});
  }

  double value_along(const elsie::Vector3& axis) const {
    double sum = 0.0;
    for (const Bright& light : lights_) {
      const double theta = std::acos(std::clamp(elsie::dot(axis, light.direction), -1.0, 1.0));
      if (law == "footbot") {
        sum += footbot(light.distance_m, light.intensity, theta);
      } else if (law == "generic" || theta <= kRightAngle) {
        sum += generic(light.distance_m, light.intensity);
      }
    }
    if (law != "khepera") return std::min(sum, 1.0);
    return sum > 0.0 ? khepera(1.0 / std::sqrt(sum)) : kDark;
  }

  std::vector<Bright> lights_;
  std::vector<elsie::LampView> leds_;
};

}  // namespace

ELSIE_SENSOR(
    Light, "light", "Sees how bright the lamps of the world and of other robots are",
    elsie::parameter("cells", &Light::cells,
                     {.min = 1, .max = 1000, .meaning = "number of light cells", .live = false}),
    elsie::parameter("fov_deg", &Light::fov_deg,
                     {.unit = "deg",
                      .above = 0,
                      .max = 360,
                      .meaning = "from the first cell to the last; 360: evenly all around"}),
    elsie::parameter("law", &Light::law,
                     {.choices = {"generic", "footbot", "khepera"},
                      .meaning = "value against distance and angle, of whose cells"}),
    elsie::parameter("led_range", &Light::led_range,
                     {.unit = "m",
                      .min = 0,
                      .max = 1000,
                      .meaning = "lamps on robots within it count; 0: none"}));
