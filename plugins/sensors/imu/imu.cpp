// An inertial measurement unit: accelerometers and gyroscopes.
//
// The velocity of the sensor's place r on a body that moves with v and turns with w is v + w x r.
// An accelerometer measures the change of that velocity over a control period, less gravity: in
// free fall it reads 0, at rest g upwards.
#include <optional>
#include <stdexcept>

#include <elsie/api/sensor.h>
#include <elsie/readings/imu.h>

namespace {

elsie::Vector3 cross(const elsie::Vector3& a, const elsie::Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

class Imu final : public elsie::SensorOf<elsie::ImuReading> {
 public:
  double gravity = 9.81;

  void equipped(const elsie::Carrier& carrier) override {
    if (carrier.mounting->segment > 0) {
      throw std::invalid_argument(
          "it measures the motion of the robot; expected it on the robot, not on a segment");
    }
  }
  void reset(elsie::Random&) override { before_.reset(); }

  elsie::ImuReading sense(const elsie::SensorContext& now) override {
    const elsie::BodyMotion motion = now.world->motion();
    const elsie::Pose pose = now.world->pose();
    const elsie::Vector3 arm = now.frame.origin - elsie::Vector3{pose.x, pose.y, 0.0};
    const elsie::Vector3 velocity = motion.velocity + cross(motion.turning, arm);
    const elsie::Vector3 change = before_ ? velocity - *before_ : elsie::Vector3{};
    before_ = velocity;
    const elsie::Vector3 force = (1.0 / now.period_s) * change + elsie::Vector3{0.0, 0.0, gravity};
    return {along_axes(now.frame, force), along_axes(now.frame, motion.turning)};
  }

 private:
  static std::array<double, 3> along_axes(const elsie::Frame& frame, const elsie::Vector3& v) {
    return {elsie::dot(frame.forward, v), elsie::dot(frame.left, v), elsie::dot(frame.up, v)};
  }

  std::optional<elsie::Vector3> before_;  // velocity at the last update; none: there was none
};

}  // namespace

ELSIE_SENSOR(Imu, "imu", "Measures accelerations and turn rates",
             elsie::parameter("gravity", &Imu::gravity,
                              {.unit = "m/s2",
                               .min = 0,
                               .max = 1000,
                               .meaning = "what it reads upwards at rest"}));
