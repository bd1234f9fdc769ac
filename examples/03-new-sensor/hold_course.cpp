#include <elsie/api/behavior.h>

#include "gyrocompass_reading.h"

// Drives in one direction of the gyrocompass.
class HoldCourse final : public elsie::Behavior {
 public:
  double course_deg = 0.0;
  double speed = 0.2;
  double gain = 2.0;

  elsie::Response respond(const elsie::Perception& now) override {
    const double heading = now.readings<GyrocompassReading>()[0]->heading_rad;
    const double off = elsie::wrap_angle(elsie::radians(course_deg) - heading);
    return elsie::Motion{speed, 0.0, gain * off};
  }
};

ELSIE_BEHAVIOR(HoldCourse, "hold_course", "Drives in one direction of the gyrocompass",
               elsie::needs<GyrocompassReading>(),
               elsie::parameter("course_deg", &HoldCourse::course_deg,
                                {.unit = "deg",
                                 .min = -180,
                                 .max = 180,
                                 .meaning = "counter-clockwise from east"}),
               elsie::parameter("speed", &HoldCourse::speed,
                                {.unit = "m/s", .min = 0, .max = 5, .meaning = "how fast"}),
               elsie::parameter("gain", &HoldCourse::gain,
                                {.unit = "1/s",
                                 .min = 0,
                                 .max = 100,
                                 .meaning = "rate of turn for each radian off the course"}));
