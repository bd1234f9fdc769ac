// Drives straight on by the gyroscope of an IMU, whatever its wheels do.
#include <elsie/api/behavior.h>
#include <elsie/readings/imu.h>

class StraightOn final : public elsie::Behavior {
 public:
  double speed = 0.2;

  elsie::Response respond(const elsie::Perception& now) override {
    turned_rad += now.readings<elsie::ImuReading>()[0]->turning_rad_s[2] * now.period_s();
    return elsie::Motion{speed, 0.0, -8.0 * turned_rad};
  }
  void reset(elsie::Random&) override { turned_rad = 0.0; }

  double turned_rad = 0.0;  // since the start of the run
};

ELSIE_BEHAVIOR(StraightOn, "straight_on", "Drives straight on by an IMU",
               elsie::needs<elsie::ImuReading>(),
               elsie::parameter("speed", &StraightOn::speed,
                                {.unit = "m/s", .min = 0, .max = 10, .meaning = "ahead"}),
               elsie::publishes("turned", &StraightOn::turned_rad,
                                {.unit = "rad", .meaning = "since the start, as it believes"}));
