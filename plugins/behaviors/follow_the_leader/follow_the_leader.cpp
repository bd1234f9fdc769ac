// Follows the leader of its team while one is within communication range.
#include <algorithm>

#include <elsie/api/remember.h>

#include "approach.h"
#include "inactive.h"

namespace {

class FollowTheLeader final : public Approach, public elsie::Remembers {
 public:
  FollowTheLeader() : Approach(0.3) {}

  void reset(elsie::Random&) override { led_ = false; }
  void remember(elsie::Memory& memory) override { memory("led", led_); }

  elsie::Response respond(const elsie::Perception& now) override {
    const elsie::TeamMate* leader = now.self().is_leader ? nullptr : now.team().leader();
    elsie::Response response = inactive();
    if (leader) {
      response = now.self().wheels.motion(towards(leader->distance_m, leader->bearing_rad));
      response.activation = std::min(1.0, leader->distance_m / far_distance);
    }
    if (led_ != (leader != nullptr)) {
      led_ = leader != nullptr;
      response.events.push_back({led_ ? "leader_in_reach" : "leader_out_of_reach"});
    }
    return response;
  }

 private:
  bool led_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    FollowTheLeader, "follow_the_leader",
    "Drives up to the leader of its team, if one is within coverage, and stands near it",
    elsie::parameter(
        "turn_above", &FollowTheLeader::turn_above,
        {.unit = "deg",
         .min = 0,
         .max = 180,
         .meaning =
             "beyond this angle from the heading, in degrees, it turns to the leader in place"}),
    elsie::parameter(
        "far_distance", &FollowTheLeader::far_distance,
        {.unit = "m", .above = 0, .meaning = "from this distance on, the leader is far"}),
    elsie::parameter("far_gain", &FollowTheLeader::far_gain,
                     {.unit = "rad/s/deg",
                      .min = 0,
                      .max = 50,
                      .meaning = "wheel rate for each degree off, when the leader is far"}),
    elsie::parameter("far_speed", &FollowTheLeader::far_speed,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 500,
                      .meaning = "wheel rate straight on, when the leader is far"}),
    elsie::parameter("near_gain", &FollowTheLeader::near_gain,
                     {.unit = "rad/s/deg",
                      .min = 0,
                      .max = 50,
                      .meaning = "wheel rate for each degree off, when the leader is near"}),
    elsie::parameter("near_speed", &FollowTheLeader::near_speed,
                     {.unit = "rad/s",
                      .min = 0,
                      .max = 500,
                      .meaning = "wheel rate straight on, when the leader is near"}),
    elsie::parameter(
        "stop_distance", &FollowTheLeader::stop_distance,
        {.unit = "m", .min = 0, .meaning = "nearer than this to the leader, it stands still"}),
    elsie::raises("leader_in_reach", "a leader of the team is within coverage now"),
    elsie::raises("leader_out_of_reach", "no leader is within coverage any more"));
