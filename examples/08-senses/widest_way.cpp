// Steers to where a depth camera sees the farthest.
#include <algorithm>
#include <cmath>

#include <elsie/api/behavior.h>
#include <elsie/readings/depth.h>

class WidestWay final : public elsie::Behavior {
 public:
  double speed = 0.2;
  double room = 0.15;

  elsie::Response respond(const elsie::Perception& now) override {
    const auto depth = now.readings<elsie::DepthReading>()[0];
    const int row = depth->height / 2;
    const auto azimuth = [&](int column) {
      return (0.5 * (depth->width - 1) - column) / depth->width * depth->horizontal_fov_rad;
    };
    double widest_m = -1.0;
    bearing_rad_ = 0.0;
    for (int column = 0; column < depth->width; ++column) {
      double way_m = depth->max_range_m;  // as far as a robot with some room beside it can go there
      for (int other = 0; other < depth->width; ++other) {
        const double off = azimuth(other) - azimuth(column), range = depth->depth_m(other, row);
        if (std::abs(range * std::sin(off)) < room) way_m = std::min(way_m, range * std::cos(off));
      }
      if (way_m > widest_m) {
        widest_m = way_m;
        bearing_rad_ = azimuth(column);
      }
    }
    if (widest_m < 2.0 * room) return elsie::Motion{0.0, 0.0, 1.0};  // it looks around
    return elsie::Motion{speed * std::cos(bearing_rad_), 0.0, 2.0 * bearing_rad_};
  }
  void sketch(elsie::Sketch& sketch) const override {
    sketch.arrow(elsie::SketchRole::wish, {},
                 {0.5 * std::cos(bearing_rad_), 0.5 * std::sin(bearing_rad_), 0.0});
  }

 private:
  double bearing_rad_ = 0.0;
};

ELSIE_BEHAVIOR(WidestWay, "widest_way", "Steers to where a depth camera sees the farthest",
               elsie::needs<elsie::DepthReading>(),
               elsie::parameter("speed", &WidestWay::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "straight on"}),
               elsie::parameter("room", &WidestWay::room,
                                {.unit = "m", .min = 0, .max = 10, .meaning = "to either side"}));
