// Aggregation, a basis behaviour of groups (Mataric 1994, 1995): towards the centroid of the robots
// around, until it is near.
#include <cmath>
#include <limits>

#include <elsie/api/remember.h>

#include "heading_for.h"
#include "inactive.h"
#include "mates.h"

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

class Aggregate final : public AmongMates, public elsie::Remembers {
 public:
  double distance = 0.3;
  double speed = 0.2;
  double gain = 4.0;

  void reset(elsie::Random&) override {
    is_there_ = false;
    away_m_ = kNone;
  }
  void remember(elsie::Memory& memory) override { memory("is_there", is_there_); }

  elsie::Response respond(const elsie::Perception& now) override {
    double ahead = 0.0, left = 0.0;  // sums, then the centroid
    int mates = 0;
    for_each_mate(now, [&](const Neighbour& mate) {
      ahead += mate.distance_m * std::cos(mate.bearing_rad);
      left += mate.distance_m * std::sin(mate.bearing_rad);
      ++mates;
    });
    away_m_ = mates > 0 ? std::hypot(ahead / mates, left / mates) : kNone;
    elsie::Response response = inactive();
    if (away_m_ > distance) {
      response = heading_for(std::atan2(left, ahead), speed, gain);
    }
    const bool is_there = away_m_ <= distance;  // not if there is nobody
    if (is_there_ != is_there) {
      is_there_ = is_there;
      response.events.push_back({is_there ? "aggregated" : "apart"});
    }
    return response;
  }

  double away_m_ = kNone;

 private:
  bool is_there_ = false;
};

}  // namespace

ELSIE_BEHAVIOR(
    Aggregate, "aggregate", "Drives to the middle of the other robots, and stops near it",
    elsie::hears<elsie::HeadingMessage>(), from_of_mates(),
    elsie::parameter("distance", &Aggregate::distance,
                     {.unit = "m",
                      .above = 0,
                      .max = 1e4,
                      .meaning = "as near as this to the middle of the others it stops"}),
    elsie::parameter("speed", &Aggregate::speed,
                     {.unit = "m/s", .min = 0, .max = 50, .meaning = "how fast, straight on"}),
    elsie::parameter(
        "gain", &Aggregate::gain,
        {.unit = "1/s", .min = 0, .max = 100, .meaning = "turn rate for each radian off"}),
    elsie::raises("aggregated", "it has come near the middle of the others"),
    elsie::raises("apart", "the middle of the others is no longer near, or there are none"),
    elsie::publishes("away", &Aggregate::away_m_,
                     {.unit = "m",
                      .meaning = "to the middle of the others; none: it perceives none"}));
