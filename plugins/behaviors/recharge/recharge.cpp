// Drives to the team's charger when the battery runs low, and stands there until it is full.
//
//   idle --[energy <= start_level x capacity, and there is a charger]--> seeking
//   seeking --[nearer than stop_distance]--> charging
//   charging --[moved away before it is full]--> seeking
//   seeking, charging --[full]--> idle
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <elsie/api/remember.h>

#include "approach.h"
#include "inactive.h"

namespace {

class Recharge final : public Approach, public elsie::Remembers {
 public:
  double start_level = 0.1;
  double idle_speed = 10.0;

  Recharge() : Approach(0.1) {}

  void equipped(const elsie::Perception& example) override {
    has_charger_ = example.team().charger.has_value();
  }

  std::vector<std::string> notes() const override {
    if (has_charger_) {
      return {};
    }
    return {
        "the world has no charger for this robot's team: with a low battery it drives on as before "
        "and raises the event 'no_charger'; give it a <charger>"};
  }

  void reset(elsie::Random&) override {
    status_ = Status::idle;
    said_no_charger_ = false;
    waiting_since_s_ = -1.0;
  }
  void remember(elsie::Memory& memory) override {
    memory("status", status_);
    memory("said_no_charger", said_no_charger_);
    memory("waiting_since_s", waiting_since_s_);
  }

  elsie::Response respond(const elsie::Perception& now) override {
    std::vector<elsie::Event> events;
    decide_status(now, events);
    elsie::Response response = inactive(now.self().wheels.motion({idle_speed, idle_speed}));
    if (status_ == Status::seeking) {
      response = now.self().wheels.motion(towards(distance_m_, bearing_rad_));
      response.activation = urgency(now.self());
    } else if (status_ == Status::charging) {
      response = elsie::Response();
      response.charge = true;
    }
    response.events = std::move(events);
    return response;
  }

 private:
  enum class Status { idle, seeking, charging };

  /// Time after which a robot that stands at the charger without being charged reports it.
  static constexpr double kPatience = 1.0;  // s

  void decide_status(const elsie::Perception& now, std::vector<elsie::Event>& events) {
    const elsie::OwnState& self = now.self();
    const bool low = self.energy <= start_level * self.capacity;
    const auto& charger = now.team().charger;
    said_no_charger_ = said_no_charger_ && low;
    if (status_ != Status::idle && self.energy >= self.capacity) {
      status_ = Status::idle;
      events.push_back({"recharged"});
    }
    if (!charger) {
      status_ = Status::idle;
      if (low && !said_no_charger_) {
        said_no_charger_ = true;
        events.push_back({"no_charger"});
      }
      return;
    }
    if (status_ == Status::idle && low) {
      status_ = Status::seeking;
      events.push_back({"battery_low"});
    }
    if (status_ == Status::idle) {
      return;
    }
    distance_m_ = std::hypot(charger->x - self.pose.x, charger->y - self.pose.y);
    bearing_rad_ = elsie::bearing(self.pose, charger->x, charger->y);
    const bool stays = status_ == Status::charging && self.charging;
    if (distance_m_ < stop_distance || stays) {
      if (status_ == Status::seeking) {
        status_ = Status::charging;
        waiting_since_s_ = now.time_s();
        events.push_back({"at_charger"});
      }
      complain_when_waiting_in_vain(now, events);
    } else {
      status_ = Status::seeking;
    }
  }

  void complain_when_waiting_in_vain(const elsie::Perception& now,
                                     std::vector<elsie::Event>& events) {
    if (now.self().charging) {
      waiting_since_s_ = -1.0;
    } else if (waiting_since_s_ >= 0.0 && now.time_s() - waiting_since_s_ > kPatience) {
      waiting_since_s_ = -1.0;
      events.push_back({"not_charged"});
    }
  }

  /// From 0.5 when the battery is just low, to 1 when it is empty.
  double urgency(const elsie::OwnState& self) const {
    return std::clamp(1.0 - 0.5 * self.energy / (start_level * self.capacity), 0.5, 1.0);
  }

  Status status_ = Status::idle;
  bool has_charger_ = true;
  bool said_no_charger_ = false;
  double waiting_since_s_ = -1.0;  // -1: not waiting, or has reported
  double distance_m_ = 0.0;        // to the charger
  double bearing_rad_ = 0.0;
};

}  // namespace

ELSIE_BEHAVIOR(
    Recharge, "recharge",
    "Drives to the team's charger when the battery runs low, and stays there until it is full",
    elsie::parameter(
        "start_level", &Recharge::start_level,
        {.above = 0, .max = 0.95, .meaning = "it starts at this fraction of the capacity"}),
    elsie::parameter("idle_speed", &Recharge::idle_speed,
                     {.unit = "rad/s",
                      .min = -500,
                      .max = 500,
                      .meaning = "rate of both wheels while it is not active"}),
    elsie::parameter(
        "turn_above", &Recharge::turn_above,
        {.unit = "deg",
         .min = 0,
         .max = 180,
         .meaning =
             "beyond this angle from the heading, in degrees, it turns to the charger in place"}),
    elsie::parameter(
        "far_distance", &Recharge::far_distance,
        {.unit = "m", .above = 0, .meaning = "from this distance on, the charger is far"}),
    elsie::parameter("far_gain", &Recharge::far_gain,
                     {.unit = "rad/s/deg",
                      .min = 0,
                      .max = 50,
                      .meaning = "wheel rate for each degree off, when the charger is far"}),
    elsie::parameter("far_speed", &Recharge::far_speed,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 500,
                      .meaning = "wheel rate straight on, when the charger is far"}),
    elsie::parameter("near_gain", &Recharge::near_gain,
                     {.unit = "rad/s/deg",
                      .min = 0,
                      .max = 50,
                      .meaning = "wheel rate for each degree off, when the charger is near"}),
    elsie::parameter("near_speed", &Recharge::near_speed,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 500,
                      .meaning = "wheel rate straight on, when the charger is near"}),
    elsie::parameter("stop_distance", &Recharge::stop_distance,
                     {.unit = "m",
                      .above = 0,
                      .meaning = "nearer than this to the charger, it stands still and asks to be "
                                 "charged; must be within the charger's radius"}),
    elsie::raises("battery_low", "the battery is low: it drives to the charger"),
    elsie::raises("at_charger", "it stands at the charger and asks to be charged"),
    elsie::raises("recharged", "the battery is full again"),
    elsie::raises(
        "not_charged",
        "it has been standing at the charger for a second and gets nothing: the charger's "
        "radius may be smaller than stop_distance"),
    elsie::raises("no_charger", "the battery is low, and the team has no charger"));
