// The joints of one robot, and its state.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "elsie/physics/engine.h"

#include "contact_solver.h"
#include "mover.h"

namespace elsie::physics {

/// A vehicle and the vehicles that it pulls, which are consecutive movers of the engine.
class PlanarRobot {
 public:
  /// `first`: its first mover; all of them are there.
  PlanarRobot(const BodyPlan& plan, std::uint32_t first, std::span<const Mover> movers);

  const BodyPlan& plan() const { return plan_; }
  std::uint32_t first() const { return first_; }
  std::size_t vehicles() const { return hinges_.size() + 1; }
  std::vector<Hinge>& hinges() { return hinges_; }
  const std::vector<Hinge>& hinges() const { return hinges_; }

  /// Puts all vehicles in line at a pose, at rest.
  void put(const Pose& pose, std::span<Mover> movers);
  /// Takes the state of a robot with the same plan.
  void take(const PlanarRobot& other);

  void set_joints(std::span<const JointSetting> settings, std::span<Mover> movers);
  std::span<const JointSetting> joints() const { return joints_; }

  /// Turns the steering.
  void begin(double step, std::span<Mover> movers);
  /// Puts the pulled vehicles back to their joints and reads the joints.
  void settle(std::span<Mover> movers);

  /// The direction of each wheel in its vehicle's frame, rad, for those that are steered: calls
  /// `call` with the vehicle, the number of the wheel and its heading.
  template <class Call>
  void for_each_steered(Call call) const {
    for (std::size_t i = 0; i < links_.size(); ++i) {
      const Link& link = links_[i];
      if (link.steered) call(link.vehicle, link.wheel, link.rest_rad + joints_[i].angle_rad);
    }
  }
  bool is_steered() const { return steered_; }
  /// The radius of each wheel of its settings, 0 for hitches.
  double rim_speed(std::span<const JointSetting> settings) const;
  double lever() const { return lever_; }

 private:
  /// What a setting is for.
  struct Link {
    std::uint32_t vehicle = 0;
    std::uint32_t wheel = 0;
    std::size_t motor = Undercarriage::kNoMotor;
    bool hitch = false;
    bool steered = false;
    JointSetting wanted;
    double max_steer_rad = 0.0;
    double steer_rate_rad_s = 0.0;
    double rest_rad = 0.0;
    double radius = 0.0;
  };

  void steer(std::size_t joint, double step, std::span<Mover> movers);

  BodyPlan plan_;
  std::uint32_t first_;
  bool steered_ = false;
  double lever_ = 1.0;
  std::vector<Link> links_;
  std::vector<JointSetting> joints_;  // measured
  std::vector<Hinge> hinges_;
};

}  // namespace elsie::physics
