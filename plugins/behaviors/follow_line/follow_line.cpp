// Follows a line on the floor with two or more ground sensors beside each other.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <elsie/api/behavior.h>
#include <elsie/api/remember.h>
#include <elsie/readings/ground.h>

namespace {

class FollowLine final : public elsie::Behavior, public elsie::Remembers {
 public:
  double speed = 0.1;
  double gain = 60.0;
  double least_contrast = 0.15;
  double search_turn = 2.0;
  bool dark = true;

  void equipped(const elsie::Perception& example) override {
    widest_m_ = 0.0;
    for (const auto& each : example.readings<elsie::GroundReading>()) {
      widest_m_ = std::max(widest_m_, std::abs(each.mounting().position.y));
    }
    if (widest_m_ <= 0.0) {
      throw std::invalid_argument(
          "it needs two ground sensors or more beside each other: give one of them a y above 0, "
          "and "
          "one a y below 0");
    }
  }

  void reset(elsie::Random&) override {
    side_ = 1.0;
    offset_m_ = std::numeric_limits<double>::quiet_NaN();
  }

  elsie::Response respond(const elsie::Perception& now) override {
    double sum = 0.0, moment = 0.0;
    for (const auto& each : now.readings<elsie::GroundReading>()) {
      const double line = dark ? 1.0 - each->grey : each->grey;
      sum += line;
      moment += line * each.mounting().position.y;
    }
    elsie::Response response;
    if (sum < least_contrast) {  // lost: it turns to where the line was last
      offset_m_ = std::numeric_limits<double>::quiet_NaN();
      response.command = {0.0, 0.0, side_ * search_turn};
      response.activation = 0.5;
      return response;
    }
    offset_m_ = moment / sum;
    if (std::abs(offset_m_) > 0.1 * widest_m_) side_ = offset_m_ > 0.0 ? 1.0 : -1.0;
    const double off = std::min(1.0, std::abs(offset_m_) / widest_m_);
    response.command = {speed * (1.0 - 0.7 * off), 0.0, gain * offset_m_};
    return response;
  }

  void remember(elsie::Memory& memory) override { memory("side", side_); }

  void sketch(elsie::Sketch& sketch) const override {
    if (std::isfinite(offset_m_)) {
      sketch.arrow(elsie::SketchRole::target, {}, {2.0 * widest_m_, offset_m_, 0.0});
    }
  }

  double offset_m_ = std::numeric_limits<double>::quiet_NaN();  // of the line; NaN: it is lost

 private:
  double widest_m_ = 0.0;  // farthest sensor from the robot's axis
  double side_ = 1.0;      // where the line was last: 1 left, -1 right
};

}  // namespace

ELSIE_BEHAVIOR(
    FollowLine, "follow_line", "Follows a line on the floor", elsie::needs<elsie::GroundReading>(),
    elsie::parameter("speed", &FollowLine::speed,
                     {.unit = "m/s", .min = 0, .max = 10, .meaning = "how fast, straight on"}),
    elsie::parameter("gain", &FollowLine::gain,
                     {.unit = "rad/s/m",
                      .min = 0,
                      .max = 10000,
                      .meaning = "rate of turn for each metre that the line is off"}),
    elsie::parameter("least_contrast", &FollowLine::least_contrast,
                     {.above = 0,
                      .max = 10,
                      .meaning = "the line is lost if all sensors together see less of it"}),
    elsie::parameter("search_turn", &FollowLine::search_turn,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 100,
                      .meaning = "how fast it turns to where a lost line was last"}),
    elsie::parameter("dark", &FollowLine::dark,
                     {.meaning = "whether the line is darker than the floor, or brighter"}),
    elsie::publishes("offset", &FollowLine::offset_m_,
                     {.unit = "m", .meaning = "of the line, to the left; none: it is lost"}));
