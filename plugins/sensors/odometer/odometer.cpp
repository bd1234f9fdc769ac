// An odometer: it counts how far the wheels have turned.
#include <cmath>

#include <elsie/api/sensor.h>
#include <elsie/readings/odometer.h>

namespace {

class Odometer final : public elsie::SensorOf<elsie::OdometerReading> {
 public:
  double tick = 0.0;

  void reset(elsie::Random&) override { left_m_ = right_m_ = 0.0; }

  elsie::OdometerReading sense(const elsie::SensorContext& now) override {
    const elsie::OwnState& self = now.world->self();
    const elsie::Motion path = now.world->rolled();
    const elsie::WheelRates wheels = self.wheels.wheel_rates(path);
    const double before_left = counted(left_m_), before_right = counted(right_m_);
    left_m_ += wheels.left * self.wheels.radius;
    right_m_ += wheels.right * self.wheels.radius;
    elsie::OdometerReading reading;
    reading.left_m = counted(left_m_);
    reading.right_m = counted(right_m_);
    const elsie::WheelRates turned{(reading.left_m - before_left) / self.wheels.radius,
                                   (reading.right_m - before_right) / self.wheels.radius};
    const elsie::Motion seen = self.wheels.motion(turned);
    reading.forward_m = seen.forward;
    reading.lateral_m = path.lateral;
    reading.turn_rad = seen.turn;
    return reading;
  }

 private:
  double counted(double path_m) const {
    return tick > 0.0 ? std::floor(path_m / tick) * tick : path_m;
  }

  double left_m_ = 0.0;  // paths, not rounded
  double right_m_ = 0.0;
};

}  // namespace

ELSIE_SENSOR(Odometer, "odometer", "Counts how far the wheels have turned",
             elsie::parameter("tick", &Odometer::tick,
                              {.unit = "m",
                               .min = 0,
                               .meaning = "path of a count of the encoders; 0: no counts"}));
