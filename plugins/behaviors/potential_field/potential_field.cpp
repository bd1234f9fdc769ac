// Khatib's artificial potential field (1986): the robot goes down the gradient of a well around its
// goal plus a hill around each obstacle.
#include <algorithm>
#include <cmath>
#include <vector>

#include "arrival.h"
#include "inactive.h"
#include "motor_schema.h"
#include "seen_points.h"

namespace {

class PotentialField final : public MotorSchema, public elsie::Remembers {
 public:
  double x = 0.0;
  double y = 0.0;
  double attraction = 0.5;
  double conic_beyond = 0.6;
  double repulsion = 0.001;
  double influence = 0.5;
  double apart_deg = 45.0;
  double speed = 0.3;
  double tolerance = 0.05;

  void equipped(const elsie::Perception& example) override {
    check_sees_points(example);
    near_.reserve(ray_count(example));
  }

  void reset(elsie::Random& random) override {
    MotorSchema::reset(random);
    arrival_.reset();
    potential_ = 0.0;
  }
  void remember(elsie::Memory& memory) override { arrival_.remember(memory); }

  elsie::Response respond(const elsie::Perception& now) override {
    // In the robot's frame, from P.
    const elsie::Pose& pose = now.self().pose;
    const double bearing = elsie::bearing(pose, x, y);
    const double distance = std::hypot(x - pose.x, y - pose.y);
    const elsie::Vector2 goal{distance * std::cos(bearing) - lead, distance * std::sin(bearing)};
    const double away = std::hypot(goal.x, goal.y);
    const bool arrived = attraction > 0.0 && away <= tolerance;
    // A hill at the goal may push it out and the well pull it back: that is no new arrival.
    const bool has_come = arrival_.step(arrived, away <= kLeft * tolerance);
    elsie::Vector2 force;
    potential_ = 0.0;
    if (!arrived) attract(goal, away, force);
    const bool is_near = repel(now, force);
    const double length = std::hypot(force.x, force.y);
    if (length > speed) force = {speed * force.x / length, speed * force.y / length};
    elsie::Response response = moved(force, now);
    if ((arrived || attraction == 0.0) && !is_near) response = inactive();
    if (arrived) response.status = elsie::Status::success;
    if (has_come) response.events.push_back({"arrived"});
    return response;
  }

  double potential_ = 0.0;

 private:
  /// A surface within the influence.
  struct Near {
    elsie::Vector2 from;  // unit vector from it to P
    double rho;           // m, from P
    double azimuth_rad;
  };

  void attract(const elsie::Vector2& goal, double away, elsie::Vector2& force) {
    if (away == 0.0) return;
    const double pull = attraction * std::min(away, conic_beyond);
    force.x += pull * goal.x / away;
    force.y += pull * goal.y / away;
    potential_ += away <= conic_beyond ? 0.5 * attraction * away * away
                                       : attraction * conic_beyond * (away - 0.5 * conic_beyond);
  }

  /// Adds the force of each obstacle at its nearest point; whether there is one.
  bool repel(const elsie::Perception& now, elsie::Vector2& force) {
    near_.clear();
    for_each_seen_point(now, [&](const SeenPoint& point) {
      const elsie::Vector2 way{lead - point.place.x, -point.place.y};
      const double rho = std::hypot(way.x, way.y);
      if (!(rho < influence)) return;
      // A sensor behind P may see a surface that P is in already.
      const bool is_in = way.x * point.ray.x + way.y * point.ray.y >= 0.0;
      if (is_in || rho < kLeast) {
        near_.push_back({{-point.ray.x, -point.ray.y}, kLeast, point.azimuth_rad()});
      } else {
        near_.push_back({{way.x / rho, way.y / rho}, rho, point.azimuth_rad()});
      }
    });
    for (std::size_t i = 0; i < near_.size(); ++i) {
      const double part = part_of(i);
      if (part == 0.0) continue;
      const Near& at = near_[i];
      const double slope = std::max(0.0, 1.0 / at.rho - 1.0 / influence);
      const double push = part * repulsion * slope / (at.rho * at.rho);
      force.x += push * at.from.x;
      force.y += push * at.from.y;
      potential_ += 0.5 * part * repulsion * slope * slope;
    }
    return !near_.empty();
  }

  /// 1 if no ray within `apart_deg` sees something nearer, so that it is the nearest point of an
  /// obstacle; 1 / n if n of them are as near; else 0. Neighbours decide at once in most cases.
  double part_of(std::size_t i) const {
    const double apart = elsie::radians(apart_deg);
    const double nearer = near_[i].rho * (1.0 - kEqual), as_near = near_[i].rho * (1.0 + kEqual);
    double equal = 1.0;
    for (std::size_t step = 1; step < near_.size(); ++step) {
      for (const std::size_t j : {i + step, i - step}) {  // below 0 it is larger than any index
        if (j >= near_.size() || near_[j].rho > as_near ||
            std::abs(elsie::wrap_angle(near_[j].azimuth_rad - near_[i].azimuth_rad)) > apart) {
          continue;
        }
        if (near_[j].rho < nearer) return 0.0;
        equal += 1.0;
      }
    }
    return 1.0 / equal;
  }

  static constexpr double kLeft = 3.0;     // tolerances from the goal: it has left
  static constexpr double kLeast = 0.005;  // m: nearer counts as this
  static constexpr double kEqual = 1e-9;

  Arrival arrival_;
  std::vector<Near> near_;
};

}  // namespace

ELSIE_BEHAVIOR(
    PotentialField, "potential_field",
    "Goes down the gradient of a potential: a well around a place, a hill around each obstacle",
    elsie::parameter("x", &PotentialField::x,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the goal, east"}),
    elsie::parameter("y", &PotentialField::y,
                     {.unit = "m", .min = -1e6, .max = 1e6, .meaning = "the goal, north"}),
    elsie::parameter("attraction", &PotentialField::attraction,
                     {.unit = "1/s",
                      .min = 0,
                      .max = 1e6,
                      .meaning = "xi of the well; 0: no goal, obstacles alone"}),
    elsie::parameter("conic_beyond", &PotentialField::conic_beyond,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "farther from the goal, the well is a cone: the pull stays"}),
    elsie::parameter("repulsion", &PotentialField::repulsion,
                     {.unit = "m4/s", .min = 0, .max = 1e6, .meaning = "eta of the hills"}),
    elsie::parameter("influence", &PotentialField::influence,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e6,
                      .meaning = "rho0: obstacles farther than this do not repel"}),
    elsie::parameter("apart_deg", &PotentialField::apart_deg,
                     {.unit = "deg",
                      .min = 0,
                      .max = 180,
                      .meaning = "of rays within this angle, only the one that sees the nearest "
                                 "point repels"}),
    elsie::parameter(
        "speed", &PotentialField::speed,
        {.unit = "m/s", .min = 0, .max = 50, .meaning = "the longest vector that it answers"}),
    elsie::parameter("tolerance", &PotentialField::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::parameter("lead", &PotentialField::lead, MotorSchema::lead_facts()),
    elsie::publishes("potential", &PotentialField::potential_,
                     {.unit = "m2/s", .meaning = "of the place that it is at"}),
    elsie::raises("arrived", "it has come within the tolerance of the goal"));
