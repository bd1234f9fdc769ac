// Drives so far, turns to the left, and drives so far again: by an odometer alone.
#include <elsie/api/behavior.h>
#include <elsie/readings/odometer.h>

class MeasureWay final : public elsie::Behavior {
 public:
  double first = 2.5, turn_deg = 90.0, second = 1.5;

  elsie::Response respond(const elsie::Perception& now) override {
    const auto odometer = now.readings<elsie::OdometerReading>()[0];
    way_m += odometer->forward_m;
    turned_rad_ += odometer->turn_rad;
    if (way_m < first) return elsie::Motion{0.2, 0.0, -turned_rad_};
    const double left_rad = elsie::radians(turn_deg) - turned_rad_;
    if (!has_turned_ && left_rad > 0.02) return elsie::Motion{0.0, 0.0, 0.2 + left_rad};
    has_turned_ = true;
    return elsie::Motion{way_m < first + second ? 0.2 : 0.0, 0.0, left_rad};
  }
  void reset(elsie::Random&) override {
    way_m = turned_rad_ = 0.0;
    has_turned_ = false;
  }

  double way_m = 0.0;

 private:
  double turned_rad_ = 0.0;
  bool has_turned_ = false;
};

ELSIE_BEHAVIOR(MeasureWay, "measure_way", "Drives, turns and drives again by an odometer",
               elsie::needs<elsie::OdometerReading>(),
               elsie::parameter("first", &MeasureWay::first, {.unit = "m", .min = 0}),
               elsie::parameter("turn_deg", &MeasureWay::turn_deg, {.unit = "deg", .min = 0}),
               elsie::parameter("second", &MeasureWay::second, {.unit = "m", .min = 0}),
               elsie::publishes("way", &MeasureWay::way_m, {.unit = "m", .meaning = "so far"}));
