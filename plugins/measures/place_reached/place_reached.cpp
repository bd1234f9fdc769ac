// The time at which a robot reached a place, and its least distance from it.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <elsie/api/measure.h>
#include <elsie/base/number_text.h>

namespace {

class PlaceReached final : public elsie::Measure {
 public:
  std::string robot;
  double x = 0.0;
  double y = 0.0;
  double radius = 0.2;
  std::string of;

  void equipped(const elsie::Observation& start) override {
    const auto place_of = [&](const std::string& id) {
      return static_cast<std::size_t>(&start.robot(id) - start.robots.data());
    };
    robot_ = place_of(robot);
    reference_.reset();
    if (of == robot) {
      throw std::invalid_argument("it gives the robot '" + robot +
                                  "' a place relative to itself; name another one in 'of'");
    }
    if (!of.empty()) {
      reference_ = place_of(of);
    } else if (std::abs(x) > 0.5 * start.arena_length_m ||
               std::abs(y) > 0.5 * start.arena_width_m) {
      const auto text = [](double value) { return elsie::base::number_text(value, 6); };
      const auto range = [&](double size) { return text(-0.5 * size) + " to " + text(0.5 * size); };
      throw std::invalid_argument("its place (" + text(x) + ", " + text(y) +
                                  ") is outside of the arena, which reaches from " +
                                  range(start.arena_length_m) + " in x and from " +
                                  range(start.arena_width_m) + " in y");
    }
  }
  std::vector<elsie::Quantity> quantities() const override {
    return {{"time_s", "s", "when the robot first was at the place"},
            {"nearest_m", "m", "smallest distance from the place"}};
  }
  void reset(elsie::Random&) override {
    reached_s_.reset();
    nearest_.reset();
  }
  void observe(const elsie::Observation& now) override {
    const elsie::Vector2 place =
        reference_ ? elsie::point_of(now.robots[*reference_].pose, {x, y}) : elsie::Vector2{x, y};
    const elsie::Pose& pose = now.robots[robot_].pose;
    const double distance = std::hypot(pose.x - place.x, pose.y - place.y);
    nearest_ = std::min(nearest_.value_or(distance), distance);
    if (distance <= radius && !reached_s_) {
      reached_s_ = now.time_s;
    }
  }
  void report(const elsie::RunEnd&, std::span<std::optional<double>> values) const override {
    values[0] = reached_s_;
    values[1] = nearest_;
  }

 private:
  std::size_t robot_ = 0;
  std::optional<std::size_t> reference_;
  std::optional<double> reached_s_;
  std::optional<double> nearest_;
};

}  // namespace

ELSIE_MEASURE(
    PlaceReached, "place_reached", "When a robot reached a place, and its least distance from it",
    elsie::parameter("robot", &PlaceReached::robot,
                     {.meaning = "id of the robot", .required = true}),
    elsie::parameter("x", &PlaceReached::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &PlaceReached::y, {.unit = "m", .meaning = "the place, north"}),
    elsie::parameter(
        "radius", &PlaceReached::radius,
        {.unit = "m", .above = 0, .meaning = "distance at which the robot is at the place"}),
    elsie::parameter("of", &PlaceReached::of,
                     {.meaning = "the place is relative to this robot: x ahead of it, y to its "
                                 "left; by default it is one of the arena"}));
