// Goes to a place by the dynamic window approach of D. Fox, W. Burgard and S. Thrun, "The dynamic
// window approach to collision avoidance", IEEE Robotics & Automation Magazine 4(1), 1997. Of the
// pairs (v, w) of speed and turn rate it takes the one with the highest
//
//   objective = alpha heading + beta dist + gamma velocity
//
// among those that are admissible, so that it can brake before what lies on their arc, and within
// the dynamic window, so that its accelerations reach them within an interval.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "free_arc.h"
#include "place_goal.h"
#include "seen_points.h"

namespace {

class DynamicWindow final : public PlaceGoal {
 public:
  double speed = 0.4;
  double turn_rate = 2.0;
  double acceleration = 0.5;
  double turn_acceleration = 4.0;
  double interval = 0.25;
  double margin = 0.03;
  double look = 1.5;
  double alpha = 0.8;
  double beta = 0.2;
  double gamma = 0.2;
  int speeds = 5;
  int turns = 11;
  double slow_down = 0.3;

  void equipped(const elsie::Perception& example) override { check_sees_points(example); }
  void reset(elsie::Random& random) override {
    PlaceGoal::reset(random);
    chosen_ = {};
  }
  void sketch(elsie::Sketch& sketch) const override {
    if (chosen_ == elsie::Motion{}) return;
    std::vector<elsie::Vector3> way;
    for (double t = 0.0; t <= 1.0; t += 0.05) {
      const elsie::Pose at = after_arc(chosen_, t);
      way.push_back({at.x, at.y, 0.0});
    }
    sketch.line(elsie::SketchRole::wish, way);
  }

 protected:
  void rest() override { chosen_ = {}; }
  elsie::Response approach(const elsie::Perception& now, double away_m, double off_rad) override {
    const double body = body_radius(now.self());
    obstacles_.clear();
    for_each_seen_point(now, [&](const SeenPoint& seen) {
      const elsie::Vector2& point = seen.place;
      const double away = std::hypot(point.x, point.y);
      if (away > look + body + margin) return;
      // What is within the margin already does not stop it, unless it would come nearer.
      obstacles_.push_back({point, std::min(body + margin, std::max(body, kCloser * away))});
    });
    period_ = now.period_s();
    goal_ = {away_m * std::cos(off_rad), away_m * std::sin(off_rad)};
    most_ = speed * std::min(1.0, away_m / slow_down);
    const elsie::Motion from{std::max(0.0, now.self().commanded.forward), 0.0,
                             now.self().commanded.turn};
    // Towards the best pair of the interval, as far as the accelerations get in a period; if that
    // is not admissible, the best pair of the period.
    std::optional<elsie::Motion> best = search(from, std::max(interval, period_));
    if (best) {
      best = elsie::Motion{within(best->forward, from.forward, acceleration * period_), 0.0,
                           within(best->turn, from.turn, turn_acceleration * period_)};
    }
    if (!best || !is_admissible(*best, clearance(*best))) {
      best = search(from, period_);
    }
    chosen_ = best ? *best : escaping(from);
    return chosen_;
  }

 private:
  static constexpr double kStanding = 1e-6;  // m/s
  static constexpr double kCloser = 0.9;     // of the distance of a point in the margin

  struct Obstacle {
    elsie::Vector2 point;  // in the robot's frame
    double radius;         // m, of the disc that must not touch it
  };

  static double within(double wanted, double from, double step) {
    return std::clamp(wanted, from - step, from + step);
  }

  /// The way on the arc of a motion that is free, m; at most `look`. On the spot, a disc touches
  /// nothing.
  double clearance(const elsie::Motion& motion) const {
    double free = look;
    if (motion.forward < kStanding) return free;
    const double curvature = motion.turn / motion.forward;
    for (const Obstacle& obstacle : obstacles_) {
      free = std::min(free, free_arc(obstacle.point, curvature, obstacle.radius));
    }
    return free;
  }

  /// Whether it can stop on its arc, both speed and turn rate, if it brakes after this period:
  /// v <= sqrt(2 dist a) and w <= sqrt(2 dist w / v a_turn), for the way that is left then.
  bool is_admissible(const elsie::Motion& motion, double free) const {
    const double v = motion.forward, w = std::abs(motion.turn);
    if (v < kStanding) return true;
    const double left = free - v * period_;
    return v * v <= 2.0 * left * acceleration && w * v <= 2.0 * left * turn_acceleration;
  }

  double objective(const elsie::Motion& motion, double free) const {
    // The heading where it would be after the interval, and have stopped to turn.
    const elsie::Pose at = after_arc(motion, std::max(interval, period_));
    const double stops = motion.turn * std::abs(motion.turn) / (2.0 * turn_acceleration);
    const double off = elsie::bearing({at.x, at.y, at.heading_rad + stops}, goal_.x, goal_.y);
    const double heading = 1.0 - std::abs(off) / std::numbers::pi;
    return alpha * heading + beta * free / look + gamma * motion.forward / speed;
  }

  /// As slow as it can be after a period, on the same arc.
  elsie::Motion braked(const elsie::Motion& from) const {
    if (from.forward < kStanding) {
      return {0.0, 0.0, within(0.0, from.turn, turn_acceleration * period_)};
    }
    const double part =
        std::max({0.0, 1.0 - acceleration * period_ / from.forward,
                  1.0 - turn_acceleration * period_ / std::max(1e-9, std::abs(from.turn))});
    return part * from;
  }

  /// The same where it may not stop in time: towards the arc that is free farthest.
  elsie::Motion escaping(const elsie::Motion& from) const {
    elsie::Motion best = braked(from);
    double farthest = clearance(best);
    const double slowest = std::max(0.0, from.forward - acceleration * period_);
    const double least = within(-turn_rate, from.turn, turn_acceleration * period_);
    const double most = within(turn_rate, from.turn, turn_acceleration * period_);
    for (int k = 0; k < turns; ++k) {
      const elsie::Motion motion{slowest, 0.0, least + (most - least) * k / (turns - 1)};
      const double free = clearance(motion);
      if (free > farthest) {
        best = motion;
        farthest = free;
      }
    }
    return best;
  }

  /// The best admissible pair that the accelerations reach in a time.
  std::optional<elsie::Motion> search(const elsie::Motion& from, double time_s) const {
    const double slowest = std::max(0.0, from.forward - acceleration * time_s);
    const double fastest = std::max(slowest, std::min(most_, from.forward + acceleration * time_s));
    const double least = within(-turn_rate, from.turn, turn_acceleration * time_s);
    const double most = within(turn_rate, from.turn, turn_acceleration * time_s);
    std::optional<elsie::Motion> best;
    double highest = 0.0;
    const auto consider = [&](const elsie::Motion& motion) {
      const double free = clearance(motion);
      if (!is_admissible(motion, free)) return;
      const double value = objective(motion, free);
      if (!best || value > highest) {
        best = motion;
        highest = value;
      }
    };
    consider(braked(from));
    for (int i = 0; i < speeds; ++i) {
      for (int k = 0; k < turns; ++k) {
        consider({slowest + (fastest - slowest) * i / (speeds - 1), 0.0,
                  least + (most - least) * k / (turns - 1)});
      }
    }
    return best;
  }

  std::vector<Obstacle> obstacles_;  // that it sees
  elsie::Vector2 goal_;              // in the robot's frame
  double period_ = 0.01;             // s
  double most_ = 0.0;                // m/s, so near to the place
  elsie::Motion chosen_;
};

}  // namespace

ELSIE_BEHAVIOR(
    DynamicWindow, "dynamic_window",
    "Goes to a place at speeds and turn rates from which it can brake in time",
    elsie::parameter("x", &DynamicWindow::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &DynamicWindow::y, {.unit = "m", .meaning = "the place, north"}),
    elsie::parameter("speed", &DynamicWindow::speed,
                     {.unit = "m/s", .above = 0, .max = 50, .meaning = "highest speed"}),
    elsie::parameter("turn_rate", &DynamicWindow::turn_rate,
                     {.unit = "rad/s", .above = 0, .max = 100, .meaning = "highest turn rate"}),
    elsie::parameter(
        "acceleration", &DynamicWindow::acceleration,
        {.unit = "m/s2", .above = 0, .max = 1000, .meaning = "of the speed, also when it brakes"}),
    elsie::parameter("turn_acceleration", &DynamicWindow::turn_acceleration,
                     {.unit = "rad/s2", .above = 0, .max = 10000, .meaning = "of the turn rate"}),
    elsie::parameter(
        "interval", &DynamicWindow::interval,
        {.unit = "s",
         .min = 0,
         .max = 10,
         .meaning = "the window is what it can reach in this time, or in a control period"}),
    elsie::parameter("margin", &DynamicWindow::margin,
                     {.unit = "m", .min = 0, .meaning = "distance that the body keeps"}),
    elsie::parameter("look", &DynamicWindow::look,
                     {.unit = "m", .above = 0, .meaning = "a way free so far counts as free"}),
    elsie::parameter("alpha", &DynamicWindow::alpha,
                     {.min = 0, .max = 1000, .meaning = "weight of the heading for the place"}),
    elsie::parameter("beta", &DynamicWindow::beta,
                     {.min = 0, .max = 1000, .meaning = "weight of the way that is free"}),
    elsie::parameter("gamma", &DynamicWindow::gamma,
                     {.min = 0, .max = 1000, .meaning = "weight of the speed"}),
    elsie::parameter("speeds", &DynamicWindow::speeds,
                     {.min = 2, .max = 101, .meaning = "number of speeds that it compares"}),
    elsie::parameter("turns", &DynamicWindow::turns,
                     {.min = 2, .max = 101, .meaning = "number of turn rates that it compares"}),
    elsie::parameter("slow_down", &DynamicWindow::slow_down,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "nearer than this to the place it drives more slowly"}),
    elsie::parameter("tolerance", &DynamicWindow::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"));
