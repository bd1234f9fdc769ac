// Turns and drives away from near obstacles: the repulsion of motor schemas (Arkin 1989), summed
// over the range and proximity readings.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <elsie/api/remember.h>

#include "inactive.h"
#include "two_values.h"

namespace {

class Flee final : public elsie::Behavior, public elsie::Remembers {
 public:
  double sphere = 0.5;
  double margin = 0.1;
  double proximity_weight = 0.5;
  double speed = 0.4;
  double gain = 4.0;

  void configured() override {
    if (margin >= sphere) {
      throw std::invalid_argument(
          two_values("margin", margin, "sphere", sphere, "m") +
          "repulsion grows from the sphere inwards up to the margin, so margin must be the smaller "
          "one");
    }
  }

  void equipped(const elsie::Perception& example) override {
    if (example.readings<elsie::RangeReading>().empty() &&
        example.readings<elsie::ProximityReading>().empty()) {
      throw std::invalid_argument(
          "it flees from what range and proximity sensors see, and the robot has none; add one");
    }
  }

  void reset(elsie::Random&) override {
    alarmed_ = false;
    turns_left_ = 0;
  }
  void remember(elsie::Memory& memory) override {
    memory("alarmed", alarmed_);
    memory("turns_left", turns_left_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const Threat threat = perceive(now);
    elsie::Response response = inactive();
    if (threat.nearness > 0.0) {
      response = run_from(threat);
      response.activation = threat.nearness;
    } else {
      turns_left_ = 0;
    }
    if (alarmed_ != (threat.nearness > 0.0)) {
      alarmed_ = threat.nearness > 0.0;
      response.events.push_back({alarmed_ ? "alarmed" : "calm"});
    }
    return response;
  }

 private:
  struct Threat {
    elsie::Vector2 push;    // sum of the repulsions, forward and left
    double pushes = 0.0;    // sum of their magnitudes
    double nearness = 0.0;  // the largest of them, in [0, 1]
    double open_rad = 0.0;  // direction of the weakest; in a tie, the nearest to straight ahead
  };

  Threat perceive(const elsie::Perception& now) const {
    Threat threat;
    double weakest = 2.0;
    const auto feel = [&](double azimuth_rad, double repulsion) {
      threat.push.x -= repulsion * std::cos(azimuth_rad);
      threat.push.y -= repulsion * std::sin(azimuth_rad);
      threat.pushes += repulsion;
      threat.nearness = std::max(threat.nearness, repulsion);
      if (repulsion < weakest ||
          (repulsion == weakest && std::abs(azimuth_rad) < std::abs(threat.open_rad))) {
        weakest = repulsion;
        threat.open_rad = azimuth_rad;
      }
    };
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      feel(beam.azimuth_rad(), beam->hit ? repulsion(beam->distance_m) : 0.0);
    }
    for (const auto& sensor : now.readings<elsie::ProximityReading>()) {
      feel(sensor.azimuth_rad(), sensor->detected ? proximity_weight : 0.0);
    }
    return threat;
  }

  /// 0 at the sphere and beyond, 1 at the margin and nearer.
  double repulsion(double distance_m) const {
    return std::clamp((sphere - distance_m) / (sphere - margin), 0.0, 1.0);
  }

  elsie::Motion run_from(const Threat& threat) {
    // Pushes that cancel each other add to the most open direction: between two threats the robot
    // runs out sideways instead of standing still.
    const double left_over =
        std::max(0.0, threat.pushes - std::hypot(threat.push.x, threat.push.y));
    const double x = threat.push.x + left_over * std::cos(threat.open_rad);
    const double y = threat.push.y + left_over * std::sin(threat.open_rad);
    double off = std::atan2(y, x);
    // Once it turns around it keeps to that side: with a threat straight behind, noise would make
    // it turn to and fro.
    if (std::abs(off) <= 0.5 * std::numbers::pi) {
      turns_left_ = 0;
    } else if (turns_left_ == 0) {
      turns_left_ = off > 0.0 ? 1 : -1;
    } else if (off * turns_left_ < 0.0) {
      off += 2.0 * std::numbers::pi * turns_left_;
    }
    const double forward = speed * threat.nearness * std::max(0.0, std::cos(off));
    return {forward, 0.0, gain * off};
  }

  bool alarmed_ = false;
  int turns_left_ = 0;  // 1: turns around to the left, -1: to the right
};

}  // namespace

ELSIE_BEHAVIOR(
    Flee, "flee", "Turns and drives away from what range and proximity sensors see near the robot",
    elsie::parameter(
        "sphere", &Flee::sphere,
        {.unit = "m", .above = 0, .meaning = "nearer than this, what a range sensor sees repels"}),
    elsie::parameter("margin", &Flee::margin,
                     {.unit = "m", .min = 0, .meaning = "nearer than this, it repels fully"}),
    elsie::parameter(
        "proximity_weight", &Flee::proximity_weight,
        {.min = 0, .max = 1, .meaning = "repulsion of what a proximity sensor detects"}),
    elsie::parameter(
        "speed", &Flee::speed,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "speed away from what repels fully"}),
    elsie::parameter("gain", &Flee::gain,
                     {.unit = "1/s",
                      .min = 0,
                      .max = 100,
                      .meaning = "turn rate for each radian off the way out"}),
    elsie::raises("alarmed", "something has come near"),
    elsie::raises("calm", "nothing is near any more"));
