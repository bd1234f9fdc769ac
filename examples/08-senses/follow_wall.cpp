// Follows the wall on the right of the robot by a lidar.
#include <algorithm>
#include <cmath>
#include <limits>

#include <elsie/api/behavior.h>
#include <elsie/readings/lidar.h>

class FollowWall final : public elsie::Behavior {
 public:
  double distance = 0.4;
  double speed = 0.2;

  elsie::Response respond(const elsie::Perception& now) override {
    const auto scan = now.readings<elsie::LidarReading>()[0];
    ahead_m = right_m = scan->max_range_m;
    double towards = 0.0;  // azimuth of the nearest place on the right
    for (std::size_t i = 0; i < scan->ranges_m.size(); ++i) {
      const double range = scan->ranges_m[i];
      const double azimuth = elsie::wrap_angle(scan.azimuth_rad() + scan->azimuth_rad(i));
      if (std::abs(azimuth) < 0.5) ahead_m = std::min(ahead_m, range);
      if (azimuth < -0.3 && range < right_m) {
        right_m = range;
        towards = azimuth;
      }
    }
    // Along the wall: at right angles to the nearest place, and nearer to it or farther from it.
    const double along = right_m < scan->max_range_m ? towards + elsie::radians(90) : -0.6;
    const double off = std::clamp(2.0 * (distance - right_m), -0.8, 0.8);
    const double turn = 3.0 * (along + off);
    if (ahead_m < distance) return elsie::Motion{0.0, 0.0, 1.5};
    return elsie::Motion{speed * std::max(0.2, 1.0 - 0.3 * std::abs(turn)), 0.0, turn};
  }

  void sketch(elsie::Sketch& sketch) const override {
    sketch.circle(elsie::SketchRole::wish, {}, distance);
  }

  double right_m = 0.0;  // the nearest place on the right
  double ahead_m = 0.0;
};

ELSIE_BEHAVIOR(FollowWall, "follow_wall", "Follows the wall on its right by a lidar",
               elsie::needs<elsie::LidarReading>(),
               elsie::parameter("distance", &FollowWall::distance,
                                {.unit = "m", .above = 0, .max = 10, .meaning = "to the wall"}),
               elsie::parameter("speed", &FollowWall::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "straight on"}),
               elsie::publishes("right", &FollowWall::right_m,
                                {.unit = "m", .meaning = "the nearest place on the right"}),
               elsie::publishes("ahead", &FollowWall::ahead_m,
                                {.unit = "m", .meaning = "the nearest place ahead"}));
