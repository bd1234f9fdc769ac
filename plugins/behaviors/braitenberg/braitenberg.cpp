// A Braitenberg vehicle: sensors wired to motors through a matrix of weights (Braitenberg,
// "Vehicles", 1984).
//
//   wheel rate = base + sum over the sensors of weight x excitation
//
// The excitation of a range sensor is 1 - distance / max range, that of a proximity sensor 1 or 0,
// that of an infra-red sensor its value, as a fraction of the largest. Sensors count in the order
// of the world file: all range sensors first, then proximity sensors, then infra-red ones.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <elsie/api/behavior.h>
#include <elsie/readings/infrared.h>

namespace {

class Braitenberg final : public elsie::Behavior {
 public:
  double base = 10.0;
  double default_weight = 12.0;
  std::vector<double> weights;

  void equipped(const elsie::Perception& example) override {
    const auto ranges = example.readings<elsie::RangeReading>();
    const auto switches = example.readings<elsie::ProximityReading>();
    const auto infrareds = example.readings<elsie::InfraredReading>();
    const std::size_t sensors = ranges.size() + switches.size() + infrareds.size();
    if (sensors == 0) {
      throw std::invalid_argument(
          "it is wired to range, proximity and infra-red sensors, and the robot has none; add one");
    }
    if (!weights.empty() && weights.size() != 2 * sensors) {
      throw std::invalid_argument(
          "weights has " + std::to_string(weights.size()) + " numbers, but the robot's " +
          std::to_string(sensors) +
          " sensors need two each, left and right: " + std::to_string(2 * sensors));
    }
    matrix_ = weights;
    if (matrix_.empty()) {
      for (const auto& sensor : ranges) {
        wire(sensor.azimuth_rad());
      }
      for (const auto& sensor : switches) {
        wire(sensor.azimuth_rad());
      }
      for (const auto& sensor : infrareds) {
        wire(sensor.azimuth_rad());
      }
    }
  }

  elsie::Response respond(const elsie::Perception& now) override {
    elsie::WheelRates rates{base, base};
    std::size_t i = 0;
    const auto excite = [&](double excitation) {
      rates += elsie::WheelRates{excitation * matrix_[i], excitation * matrix_[i + 1]};
      i += 2;
    };
    for (const auto& sensor : now.readings<elsie::RangeReading>()) {
      excite(1.0 - sensor->distance_m / sensor->max_range_m);
    }
    for (const auto& sensor : now.readings<elsie::ProximityReading>()) {
      excite(sensor->detected ? 1.0 : 0.0);
    }
    for (const auto& sensor : now.readings<elsie::InfraredReading>()) {
      excite(sensor->value / sensor->largest);
    }
    return now.self().wheels.motion(rates);
  }

 private:
  /// Vehicle 2a, "fear": a sensor speeds up the wheel on its own side and slows down the other one,
  /// so that the vehicle turns away. Sensors that look back have no effect.
  void wire(double azimuth_rad) {
    const double ahead = std::max(0.0, std::cos(azimuth_rad));
    const bool on_left = azimuth_rad > 0.0;
    matrix_.push_back(default_weight * ahead * (on_left ? 0.5 : -1.5));
    matrix_.push_back(default_weight * ahead * (on_left ? -1.5 : 0.5));
  }

  std::vector<double> matrix_;  // left and right weight of each sensor
};

}  // namespace

ELSIE_BEHAVIOR(
    Braitenberg, "braitenberg", "Sensors wired to motors through a matrix of weights",
    elsie::parameter("base", &Braitenberg::base,
                     {.unit = "rad/s", .meaning = "rate of both wheels when no sensor is excited"}),
    elsie::parameter(
        "weights", &Braitenberg::weights,
        {.unit = "rad/s",
         .meaning = "left and right weight of each sensor in turn: range, proximity, infra-red; "
                    "empty: each sensor makes the robot turn away from its side"}),
    elsie::parameter("default_weight", &Braitenberg::default_weight,
                     {.unit = "rad/s", .meaning = "scale of the default wiring, without weights"}));
