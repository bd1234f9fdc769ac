// The body of a robot as a list of parts, which physics, sensors, cameras and pictures walk.
//
// Lengths are in m, masses in kg, angles in rad.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/shapes/shape.h"

namespace elsie {

/// The role of a part, for drawing.
enum class PartRole : std::uint8_t { chassis, wheel, caster };

/// The joint of a chassis that nothing pulls. Other parts have one of the joints below.
struct FixedJoint {};

/// A wheel, which turns about the left axis of its frame.
struct WheelJoint {
  double torque = 0.0;  // N m, maximum of its motor; 0: no motor, it rolls freely
  bool steered = false;
  double max_steer_rad = std::numbers::pi;  // to either side; pi: no limit
  double steer_rate_rad_s = 0.0;            // how fast the steering turns
  /// The direction of the axles of the rollers on its rim, at the floor, counter-clockwise from the
  /// rolling direction. The wheel grips along these axles and slides across them. None: a tyre.
  std::optional<double> rollers_rad{};
};

/// A ball that slides on the floor in all directions.
struct CasterJoint {};

/// The joint between a vehicle and the one in front, which pulls it. It yaws about the vertical
/// axis of the vehicle in front and pitches about the transverse axis of the vehicle behind.
struct HitchJoint {
  double behind = 0.0;          // m, from the middle of the vehicle in front back to the joint
  double ahead = 0.0;           // m, from the middle of the vehicle behind forward to the joint
  double height = 0.0;          // m, of the joint above the floor
  double max_yaw_rad = 0.0;     // to either side
  double max_pitch_rad = 0.0;   // upwards and downwards
  double torque = 0.0;          // N m, of a motor that holds the yaw; 0: it turns freely
  double yaw_rate_rad_s = 0.0;  // how fast that motor turns
};

using Joint = std::variant<FixedJoint, WheelJoint, CasterJoint, HitchJoint>;

/// The set point of a joint, or its measured value: for a wheel its rate (positive forward) and
/// steering angle, for a hitch its yaw. Angles are counter-clockwise.
struct JointSetting {
  double rate_rad_s = 0.0;
  double angle_rad = 0.0;
  /// How fast the angle changes. In a set point: the speed at which to reach the angle (the sign is
  /// ignored); 0: as fast as the joint can.
  double turn_rad_s = 0.0;

  friend bool operator==(const JointSetting&, const JointSetting&) = default;
};

/// True if the joint can be controlled: a wheel with a motor or steering, or a hitch with a motor.
inline bool can_be_set(const Joint& joint) {
  if (const auto* wheel = std::get_if<WheelJoint>(&joint)) {
    return wheel->torque > 0.0 || wheel->steered;
  }
  const auto* hitch = std::get_if<HitchJoint>(&joint);
  return hitch && hitch->torque > 0.0;
}

struct Part {
  std::string name;  // unique within the body: "chassis", "left_wheel"
  PartRole role = PartRole::chassis;
  Shape shape;
  Frame frame;        // in the frame of its vehicle, with the steering straight ahead
  double mass = 0.0;  // 0: its mass is included in the chassis
  std::size_t vehicle = 0;
  Joint joint;
};

/// The body of a robot: a vehicle, and those that it pulls. The origin of a vehicle's frame is on
/// the floor below the middle of its chassis; x points ahead. The first part of each vehicle is its
/// chassis; the other parts belong to it. The chassis of a pulled vehicle has a HitchJoint.
struct BodyPlan {
  std::vector<Part> parts;

  std::size_t vehicles() const { return parts.empty() ? 0 : parts.back().vehicle + 1; }
};

}  // namespace elsie
