// Dispersion, a basis behaviour of groups (Mataric 1994, 1995): away from the centroid of the
// robots that are too near.
#include <algorithm>
#include <cmath>
#include <limits>

#include <elsie/api/remember.h>

#include "heading_for.h"
#include "inactive.h"
#include "mates.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kRounding = 1e-9;  // m; a centroid so near lies in no direction

class Disperse final : public AmongMates, public elsie::Remembers {
 public:
  double distance = 0.4;
  double speed = 0.2;
  double gain = 4.0;

  void reset(elsie::Random&) override {
    is_crowded_ = false;
    nearest_m_ = kNone;
  }
  void remember(elsie::Memory& memory) override { memory("is_crowded", is_crowded_); }

  elsie::Response respond(const elsie::Perception& now) override {
    double ahead = 0.0, left = 0.0;  // sums over those within the distance
    int near = 0;
    nearest_m_ = kNone;
    for_each_mate(now, [&](const Neighbour& mate) {
      nearest_m_ = std::isnan(nearest_m_) ? mate.distance_m : std::min(nearest_m_, mate.distance_m);
      if (mate.distance_m >= distance) return;
      ahead += mate.distance_m * std::cos(mate.bearing_rad);
      left += mate.distance_m * std::sin(mate.bearing_rad);
      ++near;
    });
    elsie::Response response;
    if (near == 0) {
      response = inactive();
    } else if (std::hypot(ahead, left) > kRounding * near) {
      response.command = heading_for(std::atan2(-left, -ahead), speed, gain);
    }
    if (is_crowded_ != (near > 0)) {
      is_crowded_ = near > 0;
      response.events.push_back({is_crowded_ ? "crowded" : "dispersed"});
    }
    return response;
  }

  double nearest_m_ = kNone;

 private:
  bool is_crowded_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    Disperse, "disperse", "Drives away from other robots that are too near",
    elsie::hears<elsie::HeadingMessage>(), from_of_mates(),
    elsie::parameter(
        "distance", &Disperse::distance,
        {.unit = "m", .above = 0, .max = 1e4, .meaning = "robots nearer than this are too near"}),
    elsie::parameter("speed", &Disperse::speed,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "how fast, straight on"}),
    elsie::parameter(
        "gain", &Disperse::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::raises("crowded", "another robot is too near"),
    elsie::raises("dispersed", "no robot is too near any more"),
    elsie::publishes("nearest", &Disperse::nearest_m_,
                     {.unit = "m", .meaning = "to the nearest robot; none: it perceives none"}));
