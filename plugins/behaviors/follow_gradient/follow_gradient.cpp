// Taxis: turns to the side on which a field is stronger, as Braitenberg's vehicles 2b do (1984).
//
// The rate of turn is proportional to the contrast (L - R) / (L + R) of what the antennae sense:
// Weber's law, which Argentine ants follow on their trails (Perna et al., 2012). For several tips,
// each counts by how far it is to the side.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <elsie/api/behavior.h>
#include <elsie/readings/antennae.h>

namespace {

class FollowGradient final : public elsie::Behavior {
 public:
  std::string antennae;
  double speed = 0.1;
  double gain = 5.0;
  double least = 0.1;
  double enough = 0.0;
  bool down = false;

  void equipped(const elsie::Perception& example) override {
    double widest = -1.0;
    for_each_tip(example, [&](double, double left) { widest = std::max(widest, std::abs(left)); });
    if (widest < 0.0) {
      throw std::invalid_argument("the robot has no antennae with the id '" + antennae + "'");
    }
    if (!(widest > 0.0)) {
      throw std::invalid_argument(
          "all tips of its antennae are on the middle line of the robot, where it cannot tell left "
          "from right; give the antennae more than 1 tip, or a y");
    }
  }

  void reset(elsie::Random&) override {
    contrast_ = std::numeric_limits<double>::quiet_NaN();
    strongest_ = 0.0;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    double difference = 0.0, sum = 0.0;
    strongest_ = 0.0;
    for_each_tip(now, [&](double value, double left) {
      difference += value * left;
      sum += std::abs(value * left);
      strongest_ = std::max(strongest_, value);
    });
    elsie::Response response;
    if (strongest_ < least || !(sum > 0.0)) {
      contrast_ = std::numeric_limits<double>::quiet_NaN();
      response.activation = response.strength = 0.0;
      return response;
    }
    contrast_ = difference / sum;
    if (enough > 0.0 && strongest_ >= enough) return response;  // it has arrived, and stays
    response.command = {speed * (1.0 - std::abs(contrast_)), 0.0,
                        (down ? -gain : gain) * contrast_};
    return response;
  }

  void sketch(elsie::Sketch& sketch) const override {
    if (std::isfinite(contrast_)) {
      const double side = down ? -contrast_ : contrast_;
      sketch.arrow(elsie::SketchRole::target, {}, {0.15, 0.1 * side, 0.0});
    }
  }

  double contrast_ = std::numeric_limits<double>::quiet_NaN();  // NaN: too little to sense
  double strongest_ = 0.0;

 private:
  /// Calls use(value, m to the left of the robot's middle line).
  template <class Use>
  void for_each_tip(const elsie::Perception& now, const Use& use) const {
    for (const auto& sensed : now.readings<elsie::AntennaeReading>()) {
      if (!antennae.empty() && sensed.sensor() != antennae) continue;
      const double across = std::cos(sensed.azimuth_rad());
      for (std::size_t i = 0; i < sensed->values.size(); ++i) {
        use(sensed->values[i], sensed.mounting().position.y + across * sensed->offset_m(i));
      }
    }
  }
};

}  // namespace

ELSIE_BEHAVIOR(
    FollowGradient, "follow_gradient", "Turns to where a field is stronger, or weaker",
    elsie::needs<elsie::AntennaeReading>(),
    elsie::parameter("antennae", &FollowGradient::antennae,
                     {.meaning = "the id of the antennae that it follows; by default all of the "
                                 "robot, whatever their fields",
                      .live = false}),
    elsie::parameter("speed", &FollowGradient::speed,
                     {.unit = "m/s", .min = 0, .max = 10, .meaning = "how fast, straight on"}),
    elsie::parameter("gain", &FollowGradient::gain,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 1000,
                      .meaning = "rate of turn if it senses something on one side only"}),
    elsie::parameter("least", &FollowGradient::least,
                     {.unit = "units/m2",
                      .min = 0,
                      .max = 1e15,
                      .meaning = "it wants nothing if it senses less at every tip"}),
    elsie::parameter("enough", &FollowGradient::enough,
                     {.unit = "units/m2",
                      .min = 0,
                      .max = 1e15,
                      .meaning = "it stops where it senses so much; 0: it never does"}),
    elsie::parameter("down", &FollowGradient::down,
                     {.meaning = "whether it turns to where the field is weaker"}),
    elsie::publishes("contrast", &FollowGradient::contrast_,
                     {.meaning = "(left - right) / (left + right); none: too little to sense"}),
    elsie::publishes("strongest", &FollowGradient::strongest_,
                     {.unit = "units/m2", .meaning = "what the tip that senses most senses"}));
