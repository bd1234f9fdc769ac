// Goes to a place through the openings between obstacles: the VFH+ of I. Ulrich and J. Borenstein,
// "VFH+: reliable obstacle avoidance for fast mobile robots", ICRA 1998. Four stages:
//
//   primary polar histogram  how near obstacles are in each direction, enlarged by the robot
//   binary histogram         blocked or free, with hysteresis between two thresholds
//   masked histogram         also blocked: what lies behind obstacles in the turning circles
//   direction                of the candidates in the openings, the one with the lowest cost
//
// The paper adds up the cells of a map; here the nearest reading of each direction counts, so that
// the number of rays does not matter and a threshold is a distance.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "place_goal.h"
#include "polar_histogram.h"
#include "seen_points.h"
#include "two_values.h"

namespace {

using elsie::wrap_angle;

class VfhPlus final : public PlaceGoal {
 public:
  double speed = 0.3;
  double gain = 3.0;
  double slow_down = 0.3;
  double range = 1.0;
  double safety = 0.05;
  double low = 0.5;
  double high = 0.6;
  double turning_radius = 0.0;
  int sectors = 72;
  double wide = 80.0;
  double mu1 = 5.0;
  double mu2 = 2.0;
  double mu3 = 2.0;

  void configured() override {
    if (low > high) {
      throw std::invalid_argument(two_values("low", low, "high", high, "") +
                                  "a sector is blocked above high and free below low, so low must "
                                  "not be the larger one");
    }
    histogram_.set({sectors, range, low, high, turning_radius});
  }
  void equipped(const elsie::Perception& example) override { check_sees_points(example); }
  std::vector<std::string> notes() const override {
    if (mu1 > mu2 + mu3) return {};
    return {
        "mu1 is not larger than mu2 and mu3 together: it may prefer to drive on to driving to "
        "the place"};
  }
  void reset(elsie::Random& random) override {
    PlaceGoal::reset(random);
    histogram_.reset();
    has_direction_ = is_stuck_ = false;
  }
  void remember(elsie::Memory& memory) override {
    PlaceGoal::remember(memory);
    histogram_.remember(memory);
    memory("direction", direction_);
    memory("has_direction", has_direction_);
    memory("is_stuck", is_stuck_);
  }
  void sketch(elsie::Sketch& sketch) const override {
    if (has_direction_) {
      sketch.arrow(elsie::SketchRole::wish, {},
                   {0.5 * range * std::cos(off_), 0.5 * range * std::sin(off_), 0.0});
    }
  }

 protected:
  void rest() override { has_direction_ = false; }
  elsie::Response approach(const elsie::Perception& now, double away_m, double off_rad) override {
    const double heading = now.self().pose.heading_rad;
    if (!has_direction_) {
      direction_ = heading;
    }
    // What lies behind the place does not matter.
    const double radius = body_radius(now.self()) + safety;
    histogram_.update(now, radius, away_m + radius);
    elsie::Response response;
    if (!choose(heading, heading + off_rad)) {
      has_direction_ = false;
      if (!is_stuck_) {
        response.events.push_back({"blocked"});
      }
      is_stuck_ = true;
      return response;
    }
    has_direction_ = true;
    is_stuck_ = false;
    off_ = wrap_angle(direction_ - heading);
    elsie::Motion& command = response.command;
    command = steer(off_, away_m, (1.0 - histogram_.nearness(heading)) * speed, gain, slow_down);
    if (turning_radius > 0.0) {  // it cannot turn on the spot
      command.forward = std::max(command.forward, kSlowest * speed);
      const double most = command.forward / turning_radius;
      command.turn = std::clamp(command.turn, -most, most);
    }
    return response;
  }

 private:
  static constexpr double kSlowest = 0.2;  // of the speed, where it must move to turn

  /// Finds the openings and, of their candidates, the best direction; false if there is none.
  bool choose(double heading, double target) {
    double best = 0.0, direction = 0.0;
    bool found = false;
    const auto consider = [&](double candidate) {
      const double cost = mu1 * std::abs(wrap_angle(candidate - target)) +
                          mu2 * std::abs(wrap_angle(candidate - heading)) +
                          mu3 * std::abs(wrap_angle(candidate - direction_));
      if (!found || cost < best) {
        best = cost;
        direction = candidate;
      }
      found = true;
    };
    const double half = 0.5 * elsie::radians(wide);
    const bool is_partly_blocked = histogram_.for_each_opening([&](double right, double span) {
      if (span < 2.0 * half) {
        consider(right + 0.5 * span);
        return;
      }
      consider(right + half);
      consider(right + span - half);
      if (std::abs(wrap_angle(target - right - 0.5 * span)) <= 0.5 * span - half) {
        consider(target);
      }
    });
    if (!is_partly_blocked) {
      consider(target);
    }
    direction_ = found ? wrap_angle(direction) : direction_;
    return found;
  }

  PolarHistogram histogram_;
  double direction_ = 0.0;  // in the world, of the last step
  double off_ = 0.0;        // the same from the heading
  bool has_direction_ = false;
  bool is_stuck_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    VfhPlus, "vfh_plus", "Goes to a place through the openings between obstacles, by VFH+",
    elsie::parameter("x", &VfhPlus::x, {.unit = "m", .meaning = "the place, east"}),
    elsie::parameter("y", &VfhPlus::y, {.unit = "m", .meaning = "the place, north"}),
    elsie::parameter("speed", &VfhPlus::speed,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "speed when all is clear"}),
    elsie::parameter(
        "gain", &VfhPlus::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::parameter("slow_down", &VfhPlus::slow_down,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "nearer than this to the place it drives more slowly"}),
    elsie::parameter(
        "range", &VfhPlus::range,
        {.unit = "m", .above = 0, .meaning = "obstacles farther than this do not count"}),
    elsie::parameter(
        "safety", &VfhPlus::safety,
        {.unit = "m", .min = 0, .meaning = "distance that the body keeps from obstacles"}),
    elsie::parameter("low", &VfhPlus::low,
                     {.above = 0,
                      .max = 1,
                      .meaning = "a sector is free below this magnitude, 1 - (d / range)^2"}),
    elsie::parameter("high", &VfhPlus::high,
                     {.above = 0,
                      .max = 0.99,
                      .meaning = "a sector is blocked above this magnitude; between the two it "
                                 "stays as it was"}),
    elsie::parameter(
        "turning_radius", &VfhPlus::turning_radius,
        {.unit = "m",
         .min = 0,
         .meaning = "of its tightest curves, whose circles must be free; 0: it turns on the spot"}),
    elsie::parameter("sectors", &VfhPlus::sectors,
                     {.min = 8, .max = 720, .meaning = "of the histograms", .live = false}),
    elsie::parameter(
        "wide", &VfhPlus::wide,
        {.unit = "deg",
         .above = 0,
         .max = 180,
         .meaning = "openings of this width and more, in degrees, are passed at a side; "
                    "narrower ones in the middle"}),
    elsie::parameter("mu1", &VfhPlus::mu1,
                     {.min = 0, .max = 1000, .meaning = "cost of not heading for the place"}),
    elsie::parameter("mu2", &VfhPlus::mu2,
                     {.min = 0, .max = 1000, .meaning = "cost of turning away from the heading"}),
    elsie::parameter("mu3", &VfhPlus::mu3,
                     {.min = 0, .max = 1000, .meaning = "cost of another direction than before"}),
    elsie::parameter("tolerance", &VfhPlus::tolerance,
                     {.unit = "m", .above = 0, .meaning = "nearer than this, it has arrived"}),
    elsie::raises("arrived", "the robot has come within the tolerance of the place"),
    elsie::raises("blocked", "no direction is free: it stands until one is"));
