// A drive: the wheels below a chassis, and how they move it.
//
// It says which parts a body has, and maps a motion to the rates and angles of its joints, within
// their limits, and back. It plans nothing: what a body is to do is for behaviours and coordinators
// to say, in motions.
#pragma once

#include <span>

#include "elsie/api/body.h"
#include "elsie/api/component.h"
#include "elsie/api/motion.h"
#include "elsie/api/registration.h"

namespace elsie {

/// What a world's file says of a robot's body, whatever its drive. Its frame: on the floor below
/// the middle of the chassis, x ahead.
struct Chassis {
  bool round = false;          // an upright cylinder, as long as it is wide; or a box
  double length = 0.08;        // m, along the heading
  double width = 0.08;         // m
  double height = 0.08;        // m
  double clearance = 0.01;     // m, from the floor to the chassis
  double mass = 0.1;           // kg
  double wheel_radius = 0.02;  // m
  double wheel_width = 0.01;   // m
  double half_axle = 0.045;    // m, half the distance between the middles of two opposite wheels
  double wheel_mass = 0.05;    // kg, of a wheel with a motor
  double wheel_torque = 0.01;  // N m, the most of each motor
};

/// The present state of a drive, for its next command.
struct DriveState {
  std::span<const JointSetting> joints;  // measured, those that can be set
  double max_speed = 0.5;                // m/s, the most of any wheel's rim
  double period_s = 0.01;                // to the next command
};

/// What turns above a body, counter-clockwise.
struct Turret {
  double angle_rad = 0.0;  // against the body
  double turn_rad_s = 0.0;
};

class Drive : public Component {
 public:
  /// Adds the parts of the drive to `plan`, whose only part is the chassis so far: wheels, casters,
  /// perhaps a second vehicle. Called after configured(). Throw (std::invalid_argument, with a
  /// sentence) when they do not fit the chassis: the world is refused then, at the drive's line.
  virtual void build(const Chassis& chassis, BodyPlan& plan) = 0;

  /// What it can be asked for.
  virtual Channels channels() const { return {}; }
  /// The two wheels of a differential drive that moves this body alike, for behaviours that think
  /// in wheel rates. By default the chassis' own.
  virtual WheelPair wheels(const Chassis& chassis) const {
    return {chassis.wheel_radius, chassis.half_axle};
  }

  /// Sets the joints of the body that can be set (can_be_set()), in the order of its parts, so that
  /// it makes the motion nearest to `asked` that it can make at no rim speed above the maximum; the
  /// direction of a motion that is too fast is kept. Returns that motion.
  virtual Motion command(const Motion& asked, const DriveState& now,
                         std::span<JointSetting> joints) = 0;
  /// The motion that these rates and angles of its joints make: odometry.
  virtual Motion odometry(std::span<const JointSetting> joints) const = 0;
  /// Of a body that does not turn with its direction of travel, like that of a synchro drive: how
  /// the robot's heading, and with it its sensors, is turned against the body.
  virtual Turret turret(std::span<const JointSetting> /*joints*/) const { return {}; }
};

/// Makes a drive class a plugin; see ELSIE_BEHAVIOR.
#define ELSIE_DRIVE(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::drive, Class, __VA_ARGS__)

}  // namespace elsie
