// Keeps a distance from the nearest thing around: the obstacle task of null-space control. Only its
// velocity towards that thing matters; across it, others may move the robot.
#include <cmath>

#include <elsie/api/behavior.h>

#include "inactive.h"
#include "seen_points.h"

namespace {

class KeepDistance final : public elsie::Behavior {
 public:
  double distance = 0.4;
  double gain = 2.0;
  double lookahead = 0.1;

  void equipped(const elsie::Perception& example) override { check_sees_points(example); }

  elsie::Response respond(const elsie::Perception& now) override {
    double nearest = distance, bearing = 0.0;
    for_each_seen_point(now, [&](const SeenPoint& seen) {
      const double away = std::hypot(seen.place.x, seen.place.y);
      if (!(away < nearest)) return;
      nearest = away;
      bearing = std::atan2(seen.place.y, seen.place.x);
    });
    gap_ = nearest;
    if (!(nearest < distance)) return inactive();
    elsie::Response response;
    // The velocity of a point ahead of the robot, along the line to the thing.
    const double speed = gain * (nearest - distance);
    const double across = speed * std::sin(bearing);
    const bool has_side = now.self().channels.lateral;
    response.command = {speed * std::cos(bearing), has_side ? across : 0.0,
                        has_side ? 0.0 : across / lookahead};
    response.matters_rad = bearing;
    return response;
  }

  void reset(elsie::Random&) override { gap_ = distance; }

  double gap() const { return gap_; }

 private:
  double gap_ = 0.0;  // from the robot's middle to the nearest thing, m; at most the distance
};

}  // namespace

ELSIE_BEHAVIOR(
    KeepDistance, "keep_distance",
    "Keeps a distance from the nearest thing; what happens across the line to it is free",
    elsie::parameter("distance", &KeepDistance::distance,
                     {.unit = "m", .above = 0, .max = 100, .meaning = "the distance it keeps"}),
    elsie::parameter("gain", &KeepDistance::gain,
                     {.unit = "1/s",
                      .above = 0,
                      .max = 100,
                      .meaning = "speed away for each metre that something is too near"}),
    elsie::parameter("lookahead", &KeepDistance::lookahead,
                     {.unit = "m",
                      .above = 0,
                      .max = 10,
                      .meaning = "how far ahead of the robot the point is that it moves, with a "
                                 "drive that cannot move to the side; as in fusion_null_space"}),
    elsie::publishes("gap", &KeepDistance::gap,
                     {.unit = "m", .meaning = "to the nearest thing, at most the distance"}));
