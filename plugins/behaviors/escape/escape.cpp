// Frees a robot that is stuck: detects that it does not move as commanded, backs up, turns to a
// random side, and becomes inactive again.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <elsie/api/remember.h>

#include "inactive.h"
#include "stuck_watch.h"
#include "two_values.h"

namespace {

class Escape final : public elsie::Behavior, public elsie::Remembers {
 public:
  double patience = 1.0;
  double collision_patience = 0.2;
  double moving = 0.2;
  double least_speed = 1e-5;
  double progress_distance = 0.1;
  double progress_time = 4.0;
  double back_distance = 0.1;
  double back_speed = 0.15;
  double turn_min = 60.0;
  double turn_max = 150.0;
  double turn_rate = 2.0;

  void configured() override {
    if (turn_min > turn_max) {
      throw std::invalid_argument(
          two_values("turn_min", turn_min, "turn_max", turn_max, "deg") +
          "the turn is drawn from between the two, so turn_min must not be the larger one");
    }
    watch_.set(
        {patience, collision_patience, moving, least_speed, progress_distance, progress_time});
  }

  void reset(elsie::Random&) override {
    watch_.reset();
    phase_ = Phase::none;
    asked_s_ = ended_s_ = -kLong;
    attempts_ = 0;
  }
  void remember(elsie::Memory& memory) override {
    watch_.remember(memory);
    memory("phase", phase_);
    memory("asked_s", asked_s_);
    memory("ended_s", ended_s_);
    memory("attempts", attempts_);
    memory("way", way_);
    memory("side", side_);
    memory("distance_m", distance_m_);
    memory("angle_rad", angle_rad_);
    memory("as_planned", as_planned_);
    memory("phase_start_s", phase_start_s_);
    memory("from.x", from_.x);
    memory("from.y", from_.y);
    memory("from.heading_rad", from_.heading_rad);
    memory("turned_rad", turned_rad_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    const bool was_away = now.time_s() - asked_s_ > std::max(kAway, 2.0 * now.period_s());
    asked_s_ = now.time_s();
    if (was_away) {  // others drove meanwhile: earlier observations are obsolete
      watch_.reset();
      phase_ = Phase::none;
    }
    std::vector<elsie::Event> events;
    if (phase_ == Phase::none && watch_.is_stuck(now)) {
      begin(now);
      events.push_back({"stuck"});
    }
    proceed(now, events);
    elsie::Response response = phase_ == Phase::none ? inactive() : command();
    response.events = std::move(events);
    return response;
  }

 private:
  enum class Phase { none, back, turn };

  static constexpr double kLong = 1e9;      // s
  static constexpr double kAway = 0.5;      // s without being asked
  static constexpr double kSameTrap = 3.0;  // s; getting stuck later counts as a new trap
  static constexpr double kSlowness = 2.0;  // times the planned duration; then it is blocked

  void begin(const elsie::Perception& now) {
    attempts_ = now.time_s() - ended_s_ < kSameTrap ? attempts_ + 1 : 0;
    // Back to where it came from, or the other way if that has just failed.
    way_ = now.self().commanded.forward < 0.0 ? 1.0 : -1.0;
    way_ = attempts_ % 2 == 0 ? way_ : -way_;
    const double distance = back_distance * now.random().uniform(0.5, 1.5);
    const double angle = elsie::radians(now.random().uniform(turn_min, turn_max));
    side_ = now.random().chance(0.5) ? 1.0 : -1.0;
    distance_m_ = distance;
    angle_rad_ = angle;
    as_planned_ = true;
    enter(Phase::back, now);
  }

  void enter(Phase phase, const elsie::Perception& now) {
    phase_ = phase;
    phase_start_s_ = now.time_s();
    from_ = now.self().pose;
    turned_rad_ = 0.0;
  }

  /// Begins the next phase when this one is finished or takes too long.
  void proceed(const elsie::Perception& now, std::vector<elsie::Event>& events) {
    const double spent = now.time_s() - phase_start_s_;
    if (phase_ == Phase::back) {
      const bool done = elsie::distance(from_, now.self().pose) >= distance_m_;
      if (done || spent > kSlowness * distance_m_ / back_speed) {
        as_planned_ = done;
        enter(Phase::turn, now);
      }
    } else if (phase_ == Phase::turn) {
      const double heading = now.self().pose.heading_rad;
      turned_rad_ += side_ * elsie::wrap_angle(heading - from_.heading_rad);
      from_.heading_rad = heading;
      const bool done = turned_rad_ >= angle_rad_;
      if (done || spent > kSlowness * angle_rad_ / turn_rate) {
        if (as_planned_ && done) {
          events.push_back({"freed"});
        }
        phase_ = Phase::none;
        ended_s_ = now.time_s();
        watch_.reset();
      }
    }
  }

  elsie::Motion command() const {
    return phase_ == Phase::back ? elsie::Motion{way_ * back_speed, 0.0, 0.0}
                                 : elsie::Motion{0.0, 0.0, side_ * turn_rate};
  }

  StuckWatch watch_;
  Phase phase_ = Phase::none;
  double asked_s_ = -kLong;
  double ended_s_ = -kLong;  // end of the last manoeuvre
  int attempts_ = 0;         // in the same trap, before this one
  // The present manoeuvre:
  double way_ = -1.0;        // -1: backwards, 1: forwards
  double side_ = 1.0;        // 1: turns left, -1: right
  double distance_m_ = 0.0;  // to back up
  double angle_rad_ = 0.0;   // to turn
  bool as_planned_ = true;
  double phase_start_s_ = 0.0;
  elsie::Pose from_;  // pose at the start of the phase; its heading is that of the last step
  double turned_rad_ = 0.0;
};

}  // namespace

ELSIE_BEHAVIOR(
    Escape, "escape",
    "Notices that the robot is stuck, backs up and turns by chance; not active otherwise",
    elsie::parameter("patience", &Escape::patience,
                     {.unit = "s",
                      .min = 0,
                      .meaning = "time without the commanded motion after which it is stuck"}),
    elsie::parameter(
        "collision_patience", &Escape::collision_patience,
        {.unit = "s", .min = 0, .meaning = "the same within a second after a collision"}),
    elsie::parameter(
        "moving", &Escape::moving,
        {.min = 0,
         .max = 1,
         .meaning = "below this fraction of the commanded speed, the robot counts as not moving"}),
    elsie::parameter("least_speed", &Escape::least_speed,
                     {.unit = "m/s",
                      .above = 0,
                      .meaning = "slower commands are not expected to move the robot; in a turn on "
                                 "the spot, the speed of the wheels"}),
    elsie::parameter("progress_distance", &Escape::progress_distance,
                     {.unit = "m", .above = 0, .meaning = "see progress_time"}),
    elsie::parameter("progress_time", &Escape::progress_time,
                     {.unit = "s",
                      .min = 0,
                      .meaning = "a robot that is commanded to move for this long and comes no "
                                 "farther than progress_distance is stuck, too; 0: progress is not "
                                 "watched"}),
    elsie::parameter(
        "back_distance", &Escape::back_distance,
        {.unit = "m",
         .above = 0,
         .meaning = "distance of backing up: random, from half of this to one and a half"}),
    elsie::parameter("back_speed", &Escape::back_speed,
                     {.unit = "m/s", .above = 0, .max = 50, .meaning = "speed of backing up"}),
    elsie::parameter(
        "turn_min", &Escape::turn_min,
        {.unit = "deg", .above = 0, .max = 360, .meaning = "the smallest turn, in degrees"}),
    elsie::parameter(
        "turn_max", &Escape::turn_max,
        {.unit = "deg", .above = 0, .max = 360, .meaning = "the largest turn, in degrees"}),
    elsie::parameter("turn_rate", &Escape::turn_rate,
                     {.unit = "rad/s",
                      .above = 0,
                      .max = 100,
                      .meaning = "rate of the turn, in radians per second"}),
    elsie::reacts_to(elsie::events::Collision::kFacts.name),
    elsie::raises("stuck", "the robot does not move as commanded: the manoeuvre begins"),
    elsie::raises("freed", "the manoeuvre is over, and the robot moved as it should"));
