#include "body_models.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "elsie/world/parts.h"

#include "bounds.h"

namespace elsie::physics {
namespace {

// A world rarely has more kinds of robots; a search among more would take too long.
constexpr std::size_t kMostModels = 32;

bool same(const Frame& a, const Frame& b) {
  return std::tie(a.origin, a.forward, a.left, a.up) == std::tie(b.origin, b.forward, b.left, b.up);
}

bool same(const Joint& a, const Joint& b) {
  if (a.index() != b.index()) return false;
  const auto wheel = [](const WheelJoint& j) {
    return std::tie(j.torque, j.steered, j.max_steer_rad, j.steer_rate_rad_s, j.rollers_rad);
  };
  const auto hitch = [](const HitchJoint& j) {
    return std::tie(j.behind, j.ahead, j.height, j.max_yaw_rad, j.max_pitch_rad, j.torque,
                    j.yaw_rate_rad_s);
  };
  if (const auto* of_a = std::get_if<WheelJoint>(&a)) {
    return wheel(*of_a) == wheel(std::get<WheelJoint>(b));
  }
  const auto* of_a = std::get_if<HitchJoint>(&a);
  return !of_a || hitch(*of_a) == hitch(std::get<HitchJoint>(b));
}

bool same(const Part& a, const Part& b) {
  return a.name == b.name && a.role == b.role && a.shape == b.shape && same(a.frame, b.frame) &&
         a.mass == b.mass && a.vehicle == b.vehicle && same(a.joint, b.joint);
}

bool is_steered(const Part& part) {
  const auto* wheel = std::get_if<WheelJoint>(&part.joint);
  return wheel && wheel->steered;
}

}  // namespace

BodyModel::BodyModel(const BodyPlan& of, const world::Physics& physics)
    : plan(of), lever(physics::lever_of(plan)) {
  for (std::size_t vehicle = 0; vehicle < plan.vehicles(); ++vehicle) {
    const std::span<const Part> parts = world::vehicle_of(plan, vehicle);
    solids.push_back(std::make_shared<std::vector<Solid>>(solids_of(parts)));
    sensor_shapes.push_back(std::make_shared<SensorShape>(SensorShape::of(parts)));
    movers.push_back(mover_of(parts, physics));
    std::size_t wheels = 0;
    for (const Part& part : parts) {
      Link link;
      link.vehicle = static_cast<std::uint32_t>(vehicle);
      link.is_hitch = std::holds_alternative<HitchJoint>(part.joint);
      if (std::holds_alternative<WheelJoint>(part.joint)) {
        const std::size_t motor = movers.back().wheels().motor_of(wheels++);
        if (motor != Undercarriage::kNoMotor) link.motor = static_cast<std::uint32_t>(motor);
        link.radius = part.shape.radius();
      }
      if (can_be_set(part.joint)) links.push_back(link);
    }
  }
}

void BodyModel::point(std::size_t vehicle, std::size_t wheel, double heading_rad) {
  const Direction ahead = Direction::of(heading_rad);
  sensor_shapes[vehicle]->wheels[wheel].axis = {-ahead.s, ahead.c, 0.0};
  std::size_t number = 0;
  for (Solid& solid : *solids[vehicle]) {
    if (solid.is_wheel && number++ == wheel) solid.ahead = ahead;
  }
}

std::shared_ptr<BodyModel> BodyModels::model_of(const BodyPlan& plan) {
  const auto is_known = [&](const std::shared_ptr<BodyModel>& model) {
    return std::equal(plan.parts.begin(), plan.parts.end(), model->plan.parts.begin(),
                      model->plan.parts.end(),
                      [](const Part& a, const Part& b) { return same(a, b); });
  };
  // The last one first: robots of a kind are often added in a row.
  const auto known = std::find_if(known_.rbegin(), known_.rend(), is_known);
  if (known != known_.rend()) return *known;
  auto made = std::make_shared<BodyModel>(plan, physics_);
  if (known_.size() < kMostModels &&
      std::none_of(plan.parts.begin(), plan.parts.end(), is_steered)) {
    known_.push_back(made);
  }
  return made;
}

}  // namespace elsie::physics
