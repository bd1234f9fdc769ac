// Follows a wall on one side at a distance, around inner and outer corners.
//
//   searching  no wall: straight on
//   following  a wall on the side: pure pursuit (Coulter 1992) of the line at the distance from it
//   turning    an obstacle ahead: away from the wall's side on the spot, until the way is clear
//   rounding   the wall has ended: an arc towards its side until it is seen again. After three
//              quarters of a circle it is lost; so is a wall that the robot was still approaching
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <elsie/api/remember.h>
#include <elsie/base/number_text.h>

#include "inactive.h"
#include "two_values.h"
#include "wall_sight.h"

namespace {

class WallFollow final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string side = "right";
  double distance = 0.3;
  double reach = 0.75;
  double front_angle = 30.0;
  double speed = 0.2;
  double lookahead = 0.3;
  double turn_rate = 1.5;

  void configured() override {
    if (reach <= distance) {
      throw std::invalid_argument(
          two_values("reach", reach, "distance", distance, "m") +
          "a wall that is farther than reach counts as none, so reach must be the larger one");
    }
    sight_.set({side == "left", elsie::radians(front_angle)});
  }

  void equipped(const elsie::Perception& example) override {
    const double corner = 0.5 * std::hypot(example.self().length_m, example.self().width_m);
    if (distance <= corner) {
      throw std::invalid_argument("distance is " + elsie::base::number_text(distance, 6) +
                                  " m from the robot's middle to the wall, but the robot's own "
                                  "corners are " +
                                  elsie::base::number_text(corner, 6) +
                                  " m from there; give it a larger one");
    }
    bool ahead = false, aside = false;
    for (const auto& beam : example.readings<elsie::RangeReading>()) {
      ahead = ahead || sight_.looks_ahead(beam.azimuth_rad());
      aside = aside || sight_.looks_aside(beam.azimuth_rad());
    }
    if (!ahead || !aside) {
      const std::string angle = elsie::base::number_text(front_angle, 6);
      throw std::invalid_argument(
          "it needs a range sensor that looks ahead (yaw_deg from -" + angle + " to " + angle +
          ") and one that looks to the " + side +
          (side == "left" ? " (" + angle + " to 150" : " (-" + angle + " to -150") +
          "), and the robot has none " +
          (aside   ? "of the first"
           : ahead ? "of the second"
                   : "of either") +
          "; add one");
    }
  }

  void reset(elsie::Random&) override {
    state_ = State::searching;
    asked_s_ = -1e9;
  }
  void remember(elsie::Memory& memory) override {
    memory("state", state_);
    memory("asked_s", asked_s_);
    memory("is_beside", is_beside_);
    memory("heading_rad", heading_rad_);
    memory("rounded_rad", rounded_rad_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const bool was_away = now.time_s() - asked_s_ > std::max(kAway, 2.0 * now.period_s());
    asked_s_ = now.time_s();
    const State before = was_away ? State::searching : state_;
    sight_.look(now, before == State::following ? kHold * reach : reach);
    const auto wall = sight_.wall();
    state_ = next(before, wall.has_value(), now.self());
    elsie::Response response = act(wall);
    if (before == State::searching && state_ != State::searching) {
      response.events.push_back({"wall_found"});
    } else if (before != State::searching && state_ == State::searching) {
      response.events.push_back({"wall_lost"});
    }
    return response;
  }

 private:
  enum class State { searching, following, turning, rounding };

  static constexpr double kAway = 0.5;   // s without being asked
  static constexpr double kClear = 1.2;  // distances ahead that end a turn
  static constexpr double kHold = 1.2;   // reaches within which a wall that was found is kept
  static constexpr double kLost = 1.5 * std::numbers::pi;

  State next(State before, bool has_wall, const elsie::OwnState& self) {
    const double clear = before == State::turning ? kClear * distance : distance;
    if (sight_.ahead() && *sight_.ahead() < clear) {
      return State::turning;
    }
    if (has_wall) {
      return State::following;
    }
    if (before == State::searching || (before == State::following && !is_beside_)) {
      return State::searching;
    }
    if (before != State::rounding) {
      rounded_rad_ = 0.0;
    } else {
      rounded_rad_ += towards_wall() * elsie::wrap_angle(self.pose.heading_rad - heading_rad_);
    }
    heading_rad_ = self.pose.heading_rad;
    return rounded_rad_ >= kLost ? State::searching : State::rounding;
  }

  elsie::Response act(const std::optional<WallSight::Wall>& wall) {
    switch (state_) {
      case State::following:
        return pursue(*wall);
      case State::turning:
        return elsie::Motion{0.0, 0.0, -towards_wall() * turn_rate};
      case State::rounding:
        return drive(speed / distance);
      case State::searching:
        break;
    }
    return inactive({speed, 0.0, 0.0});
  }

  /// Steers to the point on the wanted line that is `lookahead` ahead of the robot's position along
  /// it.
  elsie::Response pursue(const WallSight::Wall& wall) {
    const double error = wall.distance - distance;
    is_beside_ = wall.distance <= 0.5 * (distance + reach);
    const double x = lookahead * wall.along.x - error * wall.along.y;
    const double y = lookahead * wall.along.y + error * wall.along.x;
    elsie::Response response;
    if (x <= 0.0) {
      response.command.turn = (y > 0.0 ? 1.0 : -1.0) * towards_wall() * turn_rate;
    } else {
      response = drive(speed * 2.0 * y / (x * x + y * y));
    }
    response.activation = 0.5 + 0.5 * std::min(1.0, std::abs(error) / distance);
    return response;
  }

  /// Drives ahead and turns towards the wall's side at this rate (rad/s); slower if the turn would
  /// be too fast.
  elsie::Motion drive(double turn) const {
    const double scale = std::min(1.0, turn_rate / std::max(1e-9, std::abs(turn)));
    return {scale * speed, 0.0, scale * towards_wall() * turn};
  }

  double towards_wall() const { return side == "left" ? 1.0 : -1.0; }

  WallSight sight_;
  State state_ = State::searching;
  double asked_s_ = -1e9;
  bool is_beside_ = false;    // while following: is near the wall, no longer approaching it
  double heading_rad_ = 0.0;  // while rounding: in the last step
  double rounded_rad_ = 0.0;  // while rounding: turned so far
};

}  // namespace

ELSIE_BEHAVIOR(
    WallFollow, "wall_follow",
    "Follows a wall on one side at a distance, round inner and outer corners",
    elsie::needs<elsie::RangeReading>(),
    elsie::parameter("side", &WallFollow::side,
                     {.choices = {"left", "right"}, .meaning = "where the wall is"}),
    elsie::parameter(
        "distance", &WallFollow::distance,
        {.unit = "m",
         .above = 0,
         .meaning =
             "from the robot's middle to the wall; it turns away from anything nearer ahead"}),
    elsie::parameter("reach", &WallFollow::reach,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "beyond this distance from the robot's middle, there is no wall"}),
    elsie::parameter("front_angle", &WallFollow::front_angle,
                     {.unit = "deg",
                      .min = 0,
                      .max = 60,
                      .meaning = "range sensors look ahead up to this azimuth to either side, in "
                                 "degrees, and to the side beyond it, up to 150"}),
    elsie::parameter("speed", &WallFollow::speed,
                     {.unit = "m/s", .above = 0, .max = 50, .meaning = "along the wall"}),
    elsie::parameter("lookahead", &WallFollow::lookahead,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "it steers to a point this far on; shorter is sharper"}),
    elsie::parameter("turn_rate", &WallFollow::turn_rate,
                     {.unit = "rad/s",
                      .above = 0,
                      .max = 100,
                      .meaning = "fastest turn, in radians per second"}),
    elsie::raises("wall_found", "it has a wall to follow"),
    elsie::raises("wall_lost", "it has driven around the end of the wall and has lost it"));
