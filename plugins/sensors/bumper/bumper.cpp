// A bumper: a switch that contacts with a part of the body close.
#include <cmath>

#include <elsie/api/sensor.h>
#include <elsie/readings/bumper.h>

namespace {

class Bumper final : public elsie::SensorOf<elsie::BumperReading> {
 public:
  double fov_deg = 180.0;
  double least_force = 0.0;

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
    if (contact.segment != now.mounting->segment) return false;
    if (fov_deg >= 360.0) return true;
    const elsie::Mounting& at = *now.mounting;
    const elsie::Frame& frame = now.frame;
    // Of what it is mounted on. `left` is level, whatever the sensor's pitch.
    elsie::Pose carrier{0.0, 0.0, std::atan2(-frame.left.x, frame.left.y) - at.azimuth_rad};
    const elsie::Vector2 arm =
        elsie::point_of(carrier, elsie::Vector2{at.position.x, at.position.y});
    carrier.x = frame.origin.x - arm.x;
    carrier.y = frame.origin.y - arm.y;
    // A flat contact has points only at its corners; its normal says where it is.
    const double towards = elsie::bearing(carrier, contact.place.x, contact.place.y);
    const double outwards = std::atan2(-contact.normal.y, -contact.normal.x) - carrier.heading_rad;
    return is_within(towards - at.azimuth_rad) || is_within(outwards - at.azimuth_rad);
  }
  bool is_within(double off) const {
    return std::abs(elsie::wrap_angle(off)) <= 0.5 * elsie::radians(fov_deg) + 1e-9;
  }
};

}  // namespace

ELSIE_SENSOR(
    Bumper, "bumper", "Feels what presses on a part of the body", elsie::feels_contacts(),
    elsie::parameter("fov_deg", &Bumper::fov_deg,
                     {.unit = "deg",
                      .above = 0,
                      .max = 360,
                      .meaning = "the part of the body, seen from its origin, around the "
                                 "direction of yaw_deg"}),
    elsie::parameter("least_force", &Bumper::least_force,
                     {.unit = "N", .min = 0, .meaning = "the force that closes the switch"}));
