// A drive: the wheels below a chassis, and how they move it.
//
// A drive defines the parts of a body, and maps a motion to the rates and angles of its joints,
// within their limits, and back. It plans nothing: behaviours and coordinators decide on the
// motion.
#pragma once

#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/component.h"
#include "elsie/api/disturbance.h"
#include "elsie/api/motion.h"
#include "elsie/api/registration.h"

namespace elsie {

/// The data of a robot's body in a world file, for any drive. The origin of its frame is on the
/// floor below the middle of the chassis; x points ahead.
struct Chassis {
  bool round = false;          // true: an upright cylinder, as long as wide; false: a box
  double length = 0.08;        // m, along the heading
  double width = 0.08;         // m
  double height = 0.08;        // m
  double clearance = 0.01;     // m, from the floor to the chassis
  double mass = 0.1;           // kg
  double wheel_radius = 0.02;  // m
  double wheel_width = 0.01;   // m
  double half_axle = 0.045;    // m, half the distance between the middles of two opposite wheels
  double wheel_mass = 0.05;    // kg, of a wheel with a motor
  double wheel_torque = 0.01;  // N m, maximum of each motor
};

/// The present state of a drive, for its next command.
struct DriveState {
  std::span<const JointSetting> joints;  // measured; only those that can be set
  double max_speed = 0.5;                // m/s, limit of any wheel's rim
  double period_s = 0.01;                // time to the next command
  Random* random = nullptr;              // the drive's own stream
};

/// The state of a part that turns on top of a body, counter-clockwise.
struct Turret {
  double angle_rad = 0.0;  // relative to the body
  double turn_rad_s = 0.0;
};

class Drive : public Component {
 public:
  /// Adds the parts of the drive to `plan`, whose only part is the chassis so far: wheels, casters,
  /// perhaps a second vehicle. Called after configured(). Throw (std::invalid_argument, with a
  /// sentence) when they do not fit the chassis: the world is refused then.
  virtual void build(const Chassis& chassis, BodyPlan& plan) = 0;

  /// The channels of motion that it can make.
  virtual Channels channels() const { return {}; }
  /// The two wheels of an equivalent differential drive, for behaviours that use wheel rates. By
  /// default, those of the chassis.
  virtual WheelPair wheels(const Chassis& chassis) const {
    return {chassis.wheel_radius, chassis.half_axle};
  }

  /// Sets the joints that can be set (can_be_set()), in the order of the parts, for the possible
  /// motion nearest to `asked` with no rim speed above the maximum. A motion that is too fast keeps
  /// its direction. Returns the motion that it makes.
  virtual Motion command(const Motion& asked, const DriveState& now,
                         std::span<JointSetting> joints) = 0;
  /// The motion that follows from these rates and angles of the joints: odometry.
  virtual Motion odometry(std::span<const JointSetting> joints) const = 0;
  /// How the robot's heading and its sensors are turned relative to the body, for a body that does
  /// not turn with its direction of travel (a synchro drive).
  virtual Turret turret(std::span<const JointSetting> /*joints*/) const { return {}; }

  /// The noise and the failures that its element in the world file gives it, for the simulator,
  /// which applies them to what command() sets.
  const std::vector<Disturbance>& disturbances() const { return disturbances_; }
  /// Adds what every drive declares.
  static void declare_for_all(Declaration& declaration);

 private:
  std::vector<Disturbance> disturbances_;
};

/// Makes a drive class a plugin; see ELSIE_BEHAVIOR.
#define ELSIE_DRIVE(Class, ...) \
  ELSIE_REGISTER_PLUGIN_(::elsie::PluginKind::drive, Class, __VA_ARGS__)

}  // namespace elsie
