// Keeps a distance from the nearest thing around: the obstacle task of null-space control. Only its
// velocity towards that thing matters; across it, others may move the robot.
#include <cmath>

#include <elsie/api/behavior.h>

namespace {

class KeepDistance final : public elsie::Behavior {
 public:
  double distance = 0.4;
  double gain = 2.0;
  double lookahead = 0.1;

  elsie::Response respond(const elsie::Perception& now) override {
    double nearest = distance, bearing = 0.0;
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      if (!beam->hit || beam->distance_m >= nearest) continue;
      nearest = beam->distance_m;
      bearing = beam.azimuth_rad();
    }
    gap_ = nearest;
    elsie::Response response;
    if (!(nearest < distance)) {
      response.activation = 0.0;
      return response;
    }
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
  double gap_ = 0.0;  // to the nearest thing, m; at most the distance
};

}  // namespace

ELSIE_BEHAVIOR(
    KeepDistance, "keep_distance",
    "Keeps a distance from the nearest thing; what happens across the line to it is free",
    elsie::needs<elsie::RangeReading>(),
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
