// The motor schema stay-on-path (Arkin 1989): a vector towards the middle of a path, of full length
// off the path, and growing with the distance from the middle on it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "motor_schema.h"

namespace {

struct Point {
  double x = 0.0;
  double y = 0.0;
};

class StayOnPath final : public MotorSchema {
 public:
  std::vector<Point> points{{0.0, 0.0}, {1.0, 0.0}};
  double width = 0.4;
  double off_path = 0.3;
  double on_path = 0.15;
  double along = 0.0;
  bool closed = false;

  void configured() override {
    if (points.size() < 2) {
      throw std::invalid_argument("a path has two points or more, and this has 1; add a <point>");
    }
    parts_.clear();
    const std::size_t count = closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t next = (i + 1) % points.size();
      const Point &from = points[i], &to = points[next];
      const double length = std::hypot(to.x - from.x, to.y - from.y);
      if (length == 0.0) {
        throw std::invalid_argument("points " + std::to_string(i + 1) + " and " +
                                    std::to_string(next + 1) +
                                    " are the same place, and follow each other; leave one out");
      }
      parts_.push_back({from, {(to.x - from.x) / length, (to.y - from.y) / length}, length});
    }
  }

  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    offset_m_ = kNone;
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::Vector2 from = here(now);
    const Foot foot = nearest(from);
    offset_m_ = foot.away;
    const double half = 0.5 * width;
    const double pull = foot.away > half ? off_path : on_path * foot.away / half;
    elsie::Vector2 velocity{along * foot.ahead.x, along * foot.ahead.y};
    if (foot.away > 0.0) {
      velocity.x += pull * (foot.x - from.x) / foot.away;
      velocity.y += pull * (foot.y - from.y) / foot.away;
    }
    elsie::Response response = moved_in_world(velocity, now);
    if (along == 0.0) response.activation = std::min(1.0, foot.away / half);
    return response;
  }

  double offset_m_ = kNone;

 private:
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

  /// From one point to the next.
  struct Part {
    Point from;
    elsie::Vector2 ahead;  // unit vector
    double length;         // m
  };

  /// The point of the path that is nearest to a place.
  struct Foot {
    double x = 0.0, y = 0.0;
    double away = std::numeric_limits<double>::infinity();  // m
    elsie::Vector2 ahead;                                   // along the path; zero at its end
  };

  Foot nearest(const elsie::Vector2& place) const {
    Foot best;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& [from, ahead, length] = parts_[i];
      const double on = (place.x - from.x) * ahead.x + (place.y - from.y) * ahead.y;
      const double part = std::clamp(on, 0.0, length);
      const double x = from.x + part * ahead.x, y = from.y + part * ahead.y;
      const double away = std::hypot(x - place.x, y - place.y);
      if (away >= best.away) continue;
      best = {x, y, away, ahead};
      if (on < length) continue;
      // It has come to the end of this part.
      const std::size_t next = closed ? (i + 1) % parts_.size() : i + 1;
      best.ahead = next < parts_.size() ? parts_[next].ahead : elsie::Vector2{};
    }
    return best;
  }

  std::vector<Part> parts_;
};

}  // namespace

ELSIE_BEHAVIOR(
    StayOnPath, "stay_on_path", "A vector towards the middle of a path; a motor schema",
    elsie::elements(
        &StayOnPath::points,
        elsie::element<Point>(
            "point", "a point of the path, in the order of the way",
            elsie::parameter("x", &Point::x,
                             {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "east"}),
            elsie::parameter("y", &Point::y,
                             {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "north"}))),
    elsie::parameter("width", &StayOnPath::width,
                     {.unit = "m", .min = 0.001, .max = 1e6, .meaning = "of the path"}),
    elsie::parameter(
        "off_path", &StayOnPath::off_path,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "length of the vector off the path"}),
    elsie::parameter(
        "on_path", &StayOnPath::on_path,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "its length at the edge of the path"}),
    elsie::parameter("along", &StayOnPath::along,
                     {.unit = "m/s",
                      .min = 0,
                      .max = 50,
                      .meaning = "a vector along the path that is added, up to its last point"}),
    elsie::parameter("closed", &StayOnPath::closed,
                     {.meaning = "whether the path leads from the last point to the first"}),
    elsie::parameter("lead", &StayOnPath::lead, MotorSchema::lead_facts()),
    elsie::publishes("offset", &StayOnPath::offset_m_,
                     {.unit = "m", .meaning = "from the middle of the path"}));
