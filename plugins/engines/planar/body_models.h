// What robots with equal bodies share.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "elsie/api/body.h"

#include "planar_scene.h"
#include "planar_vehicle.h"

namespace elsie::physics {

struct BodyModel {
  /// What a setting of a joint is for.
  struct Link {
    std::uint32_t vehicle = 0;
    std::uint32_t motor = kNoMotor;  // of the vehicle's undercarriage
    double radius = 0.0;             // m, of a wheel
    bool is_hitch = false;
  };
  static constexpr std::uint32_t kNoMotor = 0xffffffff;

  BodyPlan plan;
  double lever = 1.0;
  std::vector<Link> links;  // of the joints that can be set
  // For each vehicle:
  std::vector<std::shared_ptr<std::vector<Solid>>> solids;
  std::vector<std::shared_ptr<SensorShape>> sensor_shapes;
  std::vector<Mover> movers;  // in their first state

  BodyModel(const BodyPlan& plan, const world::Physics& physics);
  /// Points a wheel of a vehicle in this direction of the vehicle's frame.
  void point(std::size_t vehicle, std::size_t wheel, double heading_rad);
};

/// Finds models by their plans. Steered wheels change a model, so that such robots share none.
class BodyModels {
 public:
  explicit BodyModels(const world::Physics& physics) : physics_(physics) {}

  std::shared_ptr<BodyModel> model_of(const BodyPlan& plan);

 private:
  const world::Physics& physics_;
  std::vector<std::shared_ptr<BodyModel>> known_;
};

}  // namespace elsie::physics
