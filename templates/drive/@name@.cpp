// @name@: what it moves on, in a sentence.
#include <algorithm>
#include <cmath>

#include <elsie/api/drive.h>

class @Class@ final : public elsie::Drive {
 public:
  // Parameters of the world file. Their defaults are set only here.
  double track = 0.1;  // m

  // The wheels below the chassis. Throws if they do not fit.
  void build(const elsie::Chassis& chassis, elsie::BodyPlan& plan) override {
    pair_ = {chassis.wheel_radius, 0.5 * track};
    for (const double side : {1.0, -1.0}) {
      plan.parts.push_back({side > 0 ? "left_wheel" : "right_wheel",
                            elsie::PartRole::wheel,
                            elsie::Shape::wheel(chassis.wheel_radius, chassis.wheel_width),
                            {.origin = {0.0, side * 0.5 * track, chassis.wheel_radius}},
                            chassis.wheel_mass,
                            0,
                            elsie::WheelJoint{.torque = chassis.wheel_torque}});
    }
    // Two balls that glide keep the chassis level.
    const double radius = 0.4 * chassis.clearance;
    for (const double end : {0.4, -0.4}) {
      plan.parts.push_back({end > 0 ? "front_caster" : "rear_caster",
                            elsie::PartRole::caster,
                            elsie::Shape::sphere(radius),
                            {.origin = {end * chassis.length, 0.0, radius}},
                            0.02 * chassis.mass,
                            0,
                            elsie::CasterJoint{}});
    }
  }

  // The two wheels of a differential drive that moves alike.
  elsie::WheelPair wheels(const elsie::Chassis& chassis) const override {
    return {chassis.wheel_radius, 0.5 * track};
  }

  // Sets the rates of the wheels, in the order in which build() added them, for the motion nearest
  // to the one asked for; returns that motion.
  elsie::Motion command(const elsie::Motion& asked, const elsie::DriveState& now,
                        std::span<elsie::JointSetting> joints) override {
    elsie::WheelRates rates = pair_.wheel_rates(asked);
    const double largest = std::max(std::abs(rates.left), std::abs(rates.right));
    const double most = now.max_speed / pair_.radius;
    if (largest > most) rates = (most / largest) * rates;
    joints[0] = {rates.left};
    joints[1] = {rates.right};
    return pair_.motion(rates);
  }

  // The motion that these rates make.
  elsie::Motion odometry(std::span<const elsie::JointSetting> joints) const override {
    return pair_.motion({joints[0].rate_rad_s, joints[1].rate_rad_s});
  }

 private:
  elsie::WheelPair pair_;
};

ELSIE_DRIVE(@Class@, "@name@", "Two wheels as far apart as you like",
            elsie::parameter("track", &@Class@::track,
                             {.unit = "m", .above = 0, .max = 10,
                              .meaning = "between the middles of the wheels"}));
