// The joints of one robot, and its state.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "elsie/physics/engine.h"

#include "body_models.h"
#include "contact_solver.h"
#include "mover.h"

namespace elsie::physics {

/// A vehicle and the vehicles that it pulls, which are consecutive movers of the engine.
class alignas(64) PlanarRobot {
 public:
  /// `first` is its first mover; all its movers must exist.
  PlanarRobot(std::shared_ptr<BodyModel> model, std::uint32_t first);

  const BodyPlan& plan() const { return model_->plan; }
  std::uint32_t first() const { return first_; }
  std::uint32_t vehicles() const { return vehicles_; }
  std::span<Hinge> hinges() { return jointed_ ? std::span(jointed_->hinges) : std::span<Hinge>(); }
  const Hinge& hinge(std::size_t segment) const;

  /// Whether it has steering or segments.
  bool has_joints() const { return jointed_ != nullptr; }
  /// Puts all vehicles in line at a pose, at rest.
  void put(const Pose& pose, std::span<Mover> movers);
  /// Takes the state of a robot with the same plan.
  void take(const PlanarRobot& other);

  /// Returns the speed of the fastest rim with these settings, m/s.
  double set_joints(std::span<const JointSetting> settings, std::span<Mover> movers);
  std::span<const JointSetting> joints() const { return joints_; }

  /// Turns the steering.
  void begin(double step, std::span<Mover> movers);
  /// Puts the pulled vehicles back to their joints and reads the joints.
  void settle(std::span<Mover> movers);

  /// Turns the shapes of steered wheels as the wheels are.
  void point_shapes() const {
    if (jointed_) point_wheels();
  }
  double lever() const { return model_->lever; }

 private:
  /// A wheel that is steered.
  struct Steering {
    std::uint32_t joint = 0;
    std::uint32_t wheel = 0;  // of its vehicle
    double most_rad = 0.0;    // to either side
    double rate_rad_s = 0.0;
    double rest_rad = 0.0;
    JointSetting wanted;
  };

  struct Jointed {
    std::vector<Steering> steerings;
    std::vector<Hinge> hinges;
  };

  void steer(const Steering& steering, double step, std::span<Mover> movers);
  void point_wheels() const;
  void straighten(Hinge& hinge, std::span<Mover> movers) const;
  std::span<const BodyModel::Link> links() const { return model_->links; }

  std::uint32_t first_;
  std::uint32_t vehicles_;
  std::vector<JointSetting> joints_;  // measured
  std::shared_ptr<BodyModel> model_;
  std::unique_ptr<Jointed> jointed_;  // most robots have none
};

}  // namespace elsie::physics
