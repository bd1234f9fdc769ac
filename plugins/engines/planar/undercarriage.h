// What holds a vehicle on the floor: its wheels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/world/description.h"

#include "floor_friction.h"
#include "plane.h"

namespace elsie::physics {

/// The wheels of a vehicle, with their motors and tyres.
///
/// A tyre grips in two directions, ahead and across; a wheel with rollers only along their axles,
/// one without a motor only across. The equations of a step of the length h, for the velocity V of
/// the body, and for each grip its direction J, its force F, the rate s of its wheel, and the speed
/// g s of the wheel's rim:
///
///   F = (g s - J V) / slip,  |F| <= friction times the wheel's load     the tyre
///   I (s - s0) = h (T - g F),  |T| <= torque; s = wanted, if T can       the motor
///   M (V - V0) = h sum of J' F                                         the body
///
/// As long as it is known which motors and tyres are at their limits, the forces are linear in V,
/// which follows from a system of three equations. solve() begins with the limits of the last step,
/// and changes them until they fit; usually nothing changes.
class Undercarriage {
 public:
  Undercarriage() = default;  // without wheels
  /// `loads`: the weight on each part, N. The chassis comes first.
  Undercarriage(std::span<const Part> parts, const std::vector<double>& loads,
                const Inertia& inertia, const world::Physics& physics);
  Undercarriage(const Undercarriage& other);
  Undercarriage(Undercarriage&&) = default;
  ~Undercarriage() = default;
  Undercarriage& operator=(Undercarriage&&) = default;

  /// Whether there are wheels. Without wheels, nothing else may be called.
  explicit operator bool() const { return model_ != nullptr; }

  /// Sets the direction of a wheel, rad counter-clockwise from ahead.
  void point(std::size_t wheel, double heading_rad);
  static constexpr std::size_t kNoMotor = static_cast<std::size_t>(-1);
  /// The motor of a wheel, or kNoMotor.
  std::size_t motor_of(std::size_t wheel) const;
  void set_rate(std::size_t motor, double wanted) { turnings_[motor].wanted = wanted; }
  double rate(std::size_t motor) const { return turnings_[motor].rate; }
  /// Lets all wheels stand still, or roll along with a velocity of the body (at its center of
  /// mass, in its frame).
  void roll(const Twist& velocity);

  /// The velocity after a step in which the wheels act on a body that would otherwise move at
  /// `free`. Both are those of the center of mass, in the body's frame.
  Twist solve(const Twist& free);
  /// The velocity that an impulse adds while the grips stay as solve() found them.
  const Symmetric& response() const { return response_; }
  const Inertia& inertia() const { return model_->inertia; }
  /// How often the response has changed.
  std::uint32_t changes() const { return changes_; }
  /// Takes the rates of the wheels after a step that ends with this velocity.
  void settle(const Twist& velocity);

  void take(const Undercarriage& other);

 private:
  enum class Hold : std::uint8_t { rolls, motor_up, motor_down, slides_up, slides_down };
  /// A direction in which a wheel grips, and the wheel's motor, if it drives in this direction.
  struct Grip {
    Twist along;              // its velocity from that of the body
    double limit = 0.0;       // N
    double rim = 0.0;         // m, its velocity from the wheel's rate; 0: no motor
    double stiffness = 0.0;   // N s/m, while the motor gives its most
    double torque = 0.0;      // N m, maximum
    double per_torque = 0.0;  // rad/s per N m in a step
    double per_force = 0.0;   // rad/s per N at the rim in a step
    double most = 0.0;        // rad/s, that the motor adds in a step

    bool is_driven() const { return rim != 0.0; }
  };
  /// How to aim a grip when its wheel is steered.
  struct Mount {
    Vector2 place;       // of the wheel, from the center of mass
    double angle = 0.0;  // of the grip, from the wheel's heading
    std::size_t wheel = 0;
  };
  /// What undercarriages of equal vehicles share until one is steered.
  struct Model {
    std::vector<Grip> grips;
    std::size_t count = 0;      // of the grips
    std::vector<Mount> mounts;  // of the grips
    Inertia inertia;
    double step = 0.0;
    double slip = 0.0;
    double stiffness = 0.0;  // N s/m, of a tyre
    double firmness = 0.0;   // kg, the stiffness times the step
    double friction = 0.0;
    Symmetric rolling;  // the response if nothing is at a limit

    void aim(std::size_t grip, double heading_rad);
    void find_rolling();  // after aim()
  };
  /// The state of a grip.
  struct Turning {
    double rate = 0.0;    // rad/s, of its wheel
    double wanted = 0.0;  // rad/s
    Hold hold = Hold::rolls;
  };
  /// The force of a grip that does not slide: F = stiffness (speed - J V).
  struct Law {
    double stiffness = 0.0;
    double speed = 0.0;
  };

  std::span<Turning> turnings() { return {turnings_.get(), model_->count}; }
  void own_model() {
    if (model_.use_count() > 1) model_ = std::make_shared<Model>(*model_);
  }
  // Short, and called for each grip in every step.
  [[gnu::always_inline]] Law law(const Grip& grip, const Turning& now) const;
  [[gnu::always_inline]] static double turning(const Grip& grip, const Turning& now, double pull);
  [[gnu::always_inline]] double force(const Grip& grip, const Turning& now, double moving) const;
  [[gnu::always_inline]] Hold fitting(const Grip& grip, const Turning& now,
                                      const Twist& velocity) const;
  [[gnu::always_inline]] Twist rolling(Twist momentum) const;
  [[gnu::always_inline]] bool all_roll(const Twist& velocity) const;
  void respond();
  Twist search(const Twist& momentum);

  std::shared_ptr<Model> model_;
  std::unique_ptr<Turning[]> turnings_;  // of the grips
  std::uint32_t changes_ = 0;
  bool is_loose_ = false;  // a grip is at a limit, or its motor is
  bool is_known_ = false;  // the response
  Symmetric response_;
};

}  // namespace elsie::physics
