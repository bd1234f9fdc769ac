// Keeps a place relative to the leader: the formations and the zones of "maintain formation" (Balch
// and Arkin 1998), with the velocity of the place itself added, so that the robot does not lag.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include <elsie/api/remember.h>

#include "inactive.h"
#include "stations.h"
#include "two_values.h"

namespace {

class KeepFormation final : public elsie::Behavior, public elsie::Remembers {
 public:
  std::string formation = "wedge";
  double spacing = 0.3;
  int slot = 0;
  double dead_zone = 0.02;
  double controlled_zone = 0.3;
  double speed = 0.3;
  double gain = 4.0;

  void configured() override {
    if (dead_zone >= controlled_zone) {
      throw std::invalid_argument(
          two_values("dead_zone", dead_zone, "controlled_zone", controlled_zone, "m") +
          "the speed grows from the edge of the one to the edge of the other, so dead_zone must be "
          "the smaller one");
    }
  }

  void reset(elsie::Random&) override {
    led_ = in_position_ = false;
    leader_index_ = -1;
    velocity_.reset();
  }
  void remember(elsie::Memory& memory) override {
    memory("led", led_);
    memory("in_position", in_position_);
    memory("leader_index", leader_index_);
    memory("place.x", place_.x);
    memory("place.y", place_.y);
    memory("seen_s", seen_s_);
    bool has_velocity = velocity_.has_value();
    memory("has_velocity", has_velocity);
    if (has_velocity) {
      velocity_ = velocity_.value_or(elsie::Vector2{});
      memory("velocity.x", velocity_->x);
      memory("velocity.y", velocity_->y);
    }
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::TeamMate* leader = now.self().is_leader ? nullptr : now.team().leader();
    elsie::Response response = inactive();
    std::vector<elsie::Event> events;
    if (led_ != (leader != nullptr)) {
      led_ = leader != nullptr;
      events.push_back({led_ ? "leader_in_reach" : "leader_out_of_reach"});
    }
    if (leader) {
      response = keep(*leader, now, events);
    } else {
      in_position_ = false;
      velocity_.reset();
    }
    response.events = std::move(events);
    return response;
  }

 private:
  static constexpr double kSmoothing = 0.1;        // s, of the measured velocity
  static constexpr double kStanding = 0.02;        // m/s; a place slower than this stands still
  static constexpr double kLeastActivation = 0.2;  // even in position it must keep its place

  elsie::Response keep(const elsie::TeamMate& leader, const elsie::Perception& now,
                       std::vector<elsie::Event>& events) {
    const elsie::OwnState& self = now.self();
    const elsie::Vector2 place = place_of(leader, self);
    follow(place, leader.team_index, now);
    const elsie::Vector2 off{place.x - self.pose.x, place.y - self.pose.y};
    const double error = std::hypot(off.x, off.y);
    tell(error, events);
    // The speed towards the place grows with the distance up to the edge of the controlled zone; in
    // the dead zone it is zero.
    const double zone = error <= dead_zone ? 0.0 : std::min(1.0, error / controlled_zone);
    const double pull = error > 0.0 ? speed * zone / error : 0.0;
    const elsie::Vector2 wanted{velocity_->x + pull * off.x, velocity_->y + pull * off.y};
    elsie::Response response;
    if (zone == 0.0 && std::hypot(wanted.x, wanted.y) < kStanding) {
      response.command.turn =
          gain * elsie::wrap_angle(leader.pose.heading_rad - self.pose.heading_rad);
    } else {
      response = drive(wanted, zone >= 1.0, self);
    }
    response.activation = std::max(kLeastActivation, zone);
    return response;
  }

  /// The robot's place in the world. Without a slot of its own, a robot's slot is its index among
  /// the followers of its team in the world file.
  elsie::Vector2 place_of(const elsie::TeamMate& leader, const elsie::OwnState& self) const {
    const int number = self.team_index + (leader.team_index > self.team_index ? 1 : 0);
    return elsie::point_of(leader.pose, station(formation, slot > 0 ? slot : number, spacing));
  }

  /// Measures the velocity of the place.
  void follow(const elsie::Vector2& place, int leader_index, const elsie::Perception& now) {
    const double passed = now.time_s() - seen_s_;
    const bool knows = velocity_ && leader_index == leader_index_ && passed > 0.0 &&
                       passed < std::max(kSmoothing, 2.0 * now.period_s());
    if (knows) {
      const double part = std::min(1.0, passed / kSmoothing);
      velocity_->x += part * ((place.x - place_.x) / passed - velocity_->x);
      velocity_->y += part * ((place.y - place_.y) / passed - velocity_->y);
    } else {
      velocity_ = elsie::Vector2{};
    }
    leader_index_ = leader_index;
    place_ = place;
    seen_s_ = now.time_s();
  }

  void tell(double error, std::vector<elsie::Event>& events) {
    const bool is_in = error <= (in_position_ ? controlled_zone : dead_zone);
    if (is_in != in_position_) {
      in_position_ = is_in;
      events.push_back({is_in ? "in_position" : "out_of_position"});
    }
  }

  /// Drives with a wanted velocity. Near its place the robot backs up to points behind it instead
  /// of turning around.
  elsie::Motion drive(const elsie::Vector2& wanted, bool is_far,
                      const elsie::OwnState& self) const {
    double off = elsie::wrap_angle(std::atan2(wanted.y, wanted.x) - self.pose.heading_rad);
    double forward = std::hypot(wanted.x, wanted.y) * std::cos(off);
    if (forward < 0.0) {
      if (is_far) {
        forward = 0.0;
      } else {
        off = elsie::wrap_angle(off + std::numbers::pi);
      }
    }
    return {forward, 0.0, gain * off};
  }

  bool led_ = false;
  bool in_position_ = false;
  int leader_index_ = -1;
  elsie::Vector2 place_;  // at the last step
  double seen_s_ = 0.0;
  std::optional<elsie::Vector2> velocity_;  // of the place, m/s; none without a leader
};

}  // namespace

ELSIE_BEHAVIOR(
    KeepFormation, "keep_formation",
    "Keeps a place relative to the leader: in a line, a column, a wedge or a diamond",
    elsie::parameter("formation", &KeepFormation::formation,
                     {.choices = {"line", "column", "wedge", "diamond"}, .meaning = "its shape"}),
    elsie::parameter("spacing", &KeepFormation::spacing,
                     {.unit = "m", .above = 0, .meaning = "from one place to the next"}),
    elsie::parameter(
        "slot", &KeepFormation::slot,
        {.min = 0,
         .max = 10000,
         .meaning = "the own place, from 1; 0: in the order in which the team's robots "
                    "stand in the world file, the leader left out"}),
    elsie::parameter(
        "dead_zone", &KeepFormation::dead_zone,
        {.unit = "m", .min = 0, .meaning = "as near as this to its place it is in position"}),
    elsie::parameter(
        "controlled_zone", &KeepFormation::controlled_zone,
        {.unit = "m",
         .above = 0,
         .meaning =
             "up to this distance from its place, the speed towards it grows with the distance"}),
    elsie::parameter(
        "speed", &KeepFormation::speed,
        {.unit = "m/s",
         .above = 0,
         .max = 50,
         .meaning = "speed towards its place beyond that, added to the formation's own"}),
    elsie::parameter(
        "gain", &KeepFormation::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::raises("leader_in_reach", "a leader of the team is within coverage now"),
    elsie::raises("leader_out_of_reach", "no leader is within coverage any more"),
    elsie::raises("in_position", "it has reached its place"),
    elsie::raises("out_of_position", "it has left the controlled zone around its place"));
