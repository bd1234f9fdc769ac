// A bumper: a switch that contacts with a part of the body close.
#include <cmath>

#include <elsie/api/sensor.h>
#include <elsie/readings/bumper.h>

namespace {

class Bumper final : public elsie::SensorOf<elsie::BumperReading> {
 public:
  double fov_deg = 180.0;
  double least_force = 0.0;
  int vehicle = 0;

  elsie::BumperReading sense(const elsie::SensorContext& now) override {
    elsie::BumperReading reading;
    bool touched = false;
    for (const elsie::Contact& contact : now.world->contacts()) {
      if (!is_mine(contact, now)) continue;
      touched = true;
      reading.force_n += contact.impulse_n_s / now.period_s;
    }
    reading.pressed = touched && reading.force_n >= least_force;
    return reading;
  }

  void sketch(elsie::Sketch& sketch) const override {
    const double half = 0.5 * elsie::radians(fov_deg);
    sketch.arc(current().pressed ? elsie::SketchRole::hit : elsie::SketchRole::range, {}, 0.02,
               -half, half);
  }

 private:
  bool is_mine(const elsie::Contact& contact, const elsie::SensorContext& now) const {
    if (static_cast<int>(contact.vehicle) != vehicle) return false;
    if (vehicle > 0 || fov_deg >= 360.0) return true;
    const elsie::Pose robot = now.world->pose();
    const double towards = elsie::bearing(robot, contact.place.x, contact.place.y);
    const double off = elsie::wrap_angle(towards - now.mounting->azimuth_rad);
    return std::abs(off) <= 0.5 * elsie::radians(fov_deg) + 1e-9;
  }
};

}  // namespace

ELSIE_SENSOR(
    Bumper, "bumper", "Feels what presses on a part of the body", elsie::feels_contacts(),
    elsie::parameter("fov_deg", &Bumper::fov_deg,
                     {.unit = "deg",
                      .above = 0,
                      .max = 360,
                      .meaning = "the part of the body, seen from the robot's origin, around the "
                                 "direction of yaw_deg"}),
    elsie::parameter("least_force", &Bumper::least_force,
                     {.unit = "N", .min = 0, .meaning = "the force that closes the switch"}),
    elsie::parameter("vehicle", &Bumper::vehicle,
                     {.min = 0,
                      .max = 1000,
                      .meaning = "0: the robot; n: the n-th vehicle that it pulls, all around"}));
