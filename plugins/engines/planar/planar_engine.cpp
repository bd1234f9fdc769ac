// Adding bodies to the planar engine, changing and removing them.
#include "planar_engine.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/world/parts.h"

#include "checks.h"
#include "planar_vehicle.h"

namespace elsie::physics {
namespace {

void refuse_if(const std::optional<std::string>& fault) { require(!fault, fault.value_or("")); }

world::Physics with_step(world::Physics physics, double step) {
  physics.step = step;
  return physics;
}

}  // namespace

PlanarEngine::PlanarEngine(const world::Arena& arena, const world::Physics& physics)
    : parts_((check(arena, physics), parts_of(physics.step))),
      physics_(with_step(physics, physics.step / parts_)),
      scene_(arena),
      models_(physics_),
      pipeline_(physics_, colliders_, movers_, scene_),
      bounds_(arena, physics) {
  refuse_if(fault_of(physics));
  std::size_t index = 0;
  for (const world::Fixture& wall : world::walls_of(arena)) {
    const Vector3& at = wall.frame.origin;
    const double heading = std::atan2(wall.frame.forward.y, wall.frame.forward.x);
    add_upright({BodyKind::wall, index++}, wall.shape, at.z - 0.5 * wall.shape.size.z,
                {at.x, at.y, heading}, true, std::nullopt);
  }
}

std::uint32_t PlanarEngine::add_collider(const Body& body, std::size_t vehicle,
                                         std::shared_ptr<const std::vector<Solid>> solids,
                                         std::shared_ptr<const SensorShape> sensor_shape,
                                         bool sensed, const Pose& pose,
                                         std::optional<Mover> mover) {
  Collider collider;
  collider.body = body;
  collider.vehicle = static_cast<std::uint32_t>(vehicle);
  collider.number = next_number_++;
  collider.solids = std::move(solids);
  const Vector2 place{pose.x, pose.y};
  const double reach = sensor_shape->reach;
  const std::uint32_t id = scene_.add(body, sensed, mover.has_value(), std::move(sensor_shape),
                                      place, Direction::of(pose.heading_rad));
  if (mover) {
    mover->set_reach(reach);
    mover->put(place, pose.heading_rad);
    collider.mover = static_cast<std::uint32_t>(movers_.size());
    movers_.push_back(std::move(*mover));
    moving_.push_back({id, collider.mover, reach});
  }
  colliders_.push_back(std::move(collider));
  return id;
}

std::uint32_t PlanarEngine::add_upright(const Body& body, const Shape& shape, double bottom,
                                        const Pose& pose, bool sensed, std::optional<Mover> mover) {
  auto solids = std::make_shared<std::vector<Solid>>();
  solids->push_back({Outline::of(shape, bottom + 0.5 * shape.size.z), {}, {}});
  return add_collider(body, 0, std::move(solids),
                      std::make_shared<SensorShape>(SensorShape::of(shape, bottom)), sensed, pose,
                      std::move(mover));
}

std::size_t PlanarEngine::add_robot(const BodyPlan& plan, const Pose& pose, double z) {
  world::check(plan);
  check(pose, z);
  refuse_if(physics::fault_of_height(z, "a robot"));
  refuse_if(fault_of(plan, "a robot"));
  const std::size_t index = robots_.size();
  const auto first = static_cast<std::uint32_t>(movers_.size());
  robot_bodies_.push_back({static_cast<std::uint32_t>(colliders_.size()), false});
  const std::shared_ptr<BodyModel> model = models_.model_of(plan);
  for (std::size_t vehicle = 0; vehicle < plan.vehicles(); ++vehicle) {
    add_collider({BodyKind::robot, index}, vehicle, model->solids[vehicle],
                 model->sensor_shapes[vehicle], true, pose, model->movers[vehicle]);
  }
  robots_.emplace_back(model, first);
  robots_.back().put(pose, movers_);
  if (robots_.back().has_joints()) jointed_.push_back(static_cast<std::uint32_t>(index));
  enter_robot(index);
  return index;
}

void PlanarEngine::enter_robot(std::size_t robot) {
  const Vector2& at = movers_[robots_[robot].first()].place();
  robot_bodies_[robot].stays_within = bounds_.within_walls({at.x, at.y, 0.0});
  place_in_scene(robot, moves_.front());
  scene_.settle(moves_);
}

std::size_t PlanarEngine::add_robot_of(const Engine& other, std::size_t robot) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const PlanarRobot& same = before.robots_.at(robot);
  const std::size_t index = add_robot(same.plan(), {}, 0.0);
  PlanarRobot& made = robots_[index];
  made.take(same);
  for (std::uint32_t i = 0; i < made.vehicles(); ++i) {
    movers_[made.first() + i].take(before.movers_[same.first() + i], physics_.step);
    colliders_[robot_bodies_[index].first_collider + i].number =
        before.colliders_[before.robot_bodies_[robot].first_collider + i].number;
  }
  enter_robot(index);
  take_watches(before, robot);
  return index;
}

/// The last robot is watched as it is in the other engine.
void PlanarEngine::take_watches(const PlanarEngine& other, std::size_t robot) {
  const std::size_t index = robots_.size() - 1;
  if (other.contact_watch_.watches(robot)) contact_watch_.watch(index);
}

std::size_t PlanarEngine::add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                                       const Pose& pose) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const Mover& same = before.movers_[before.robots_.at(robot).first()];
  const std::size_t index = add_robot(plan, pose, 0.0);
  const PlanarRobot& made = robots_[index];
  const Twist velocity = same.ahead().turn(same.velocity_of_origin());
  for (std::uint32_t i = 0; i < made.vehicles(); ++i) {
    movers_[made.first() + i].push(velocity, same.place(), physics_.step);
  }
  robots_[index].settle(movers_);
  take_watches(before, robot);
  return index;
}

std::size_t PlanarEngine::add_obstacle(const world::Obstacle& box) {
  check(box);
  const bool is_dynamic = box.is_dynamic();
  refuse_if(fault_of(box, "a box"));
  const std::size_t index = boxes_.size();
  const Shape shape = world::fixture_of(box).shape;
  std::optional<Mover> mover;
  if (is_dynamic) {
    const Inertia inertia{box.mass, {}, box.mass * spread_of(shape)};
    const double lever = physics::lever_of(Outline::of(shape, 0.0));
    mover.emplace(inertia, FloorFriction(inertia, lever, physics_));
  } else if (box.kind == world::ObstacleKind::moving) {
    mover.emplace();
  }
  BoxBody& made = boxes_.emplace_back();
  made.kind = is_dynamic ? world::ObstacleKind::dynamic : box.kind;
  made.hands = box.hands;
  made.bottom = box.z;
  made.collider = add_upright({BodyKind::obstacle, index}, shape, box.z,
                              {box.x, box.y, radians(box.heading_deg)}, box.seen_by_range_sensors,
                              std::move(mover));
  if (colliders_[made.collider].mover != Contact::kFixed) {
    mobile_boxes_.push_back(static_cast<std::uint32_t>(index));
  }
  made.stays_within = is_dynamic && bounds_.within_walls({box.x, box.y, 0.0});
  if (is_dynamic) take_footing(made);
  return index;
}

std::size_t PlanarEngine::add_obstacle_of(const Engine& other, std::size_t box,
                                          const world::Obstacle& added) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  const BoxBody& same = before.boxes_.at(box);
  const std::size_t index = add_obstacle(added);
  Collider& collider = colliders_[boxes_[index].collider];
  const Collider& known = before.colliders_[same.collider];
  collider.number = known.number;
  if (!same.present) {
    remove_obstacle(index);
  } else if (collider.mover != Contact::kFixed) {
    Mover& mover = movers_[collider.mover];
    mover.take(before.movers_[known.mover], physics_.step);
    scene_.move(boxes_[index].collider, mover.place(), mover.ahead(), moves_.front());
    scene_.settle(moves_);
    boxes_[index].stays_within = boxes_[index].kind == world::ObstacleKind::dynamic &&
                                 bounds_.within_walls({mover.place().x, mover.place().y, 0.0});
  }
  return index;
}

void PlanarEngine::go_on_from(const Engine& other) {
  const auto& before = dynamic_cast<const PlanarEngine&>(other);
  time_ = before.time_;
  next_number_ = std::max(next_number_, before.next_number_);
  bounds_.add(before.bounds_);
  pipeline_.take(before.pipeline_);
}

void PlanarEngine::remove_obstacle(std::size_t box) {
  BoxBody& gone = boxes_.at(box);
  if (!gone.present) return;
  gone.present = false;
  gone.holders = 0;
  if (std::erase_if(grips_, [&](const Grip& grip) { return grip.box == box; }) > 0) {
    are_grips_noted_ = false;
  }
  scene_.remove(gone.collider);
  std::erase_if(moving_, [&](const auto& moving) { return moving.collider == gone.collider; });
  std::erase(mobile_boxes_, static_cast<std::uint32_t>(box));
}

void PlanarEngine::place_robot(std::size_t robot, const Pose& pose, double z) {
  check(pose, z);
  refuse_if(physics::fault_of_height(z, "a robot"));
  robots_.at(robot).put(pose, movers_);
  enter_robot(robot);
}

void PlanarEngine::place_obstacle(std::size_t box, const Pose& pose) {
  BoxBody& placed = boxes_.at(box);
  check(pose, 0.0);
  const Collider& collider = colliders_[placed.collider];
  const Vector2 place{pose.x, pose.y};
  if (collider.mover != Contact::kFixed) {
    Mover& mover = movers_[collider.mover];
    mover.put(place, pose.heading_rad);
    mover.stop();
    placed.driven = false;
    if (placed.kind == world::ObstacleKind::dynamic) take_footing(placed);
    placed.stays_within = placed.kind == world::ObstacleKind::dynamic &&
                          bounds_.within_walls({place.x, place.y, 0.0});
    if (!placed.present) {  // both lists are in the order of adding
      const auto after = std::find_if(moving_.begin(), moving_.end(), [&](const auto& moving) {
        return moving.collider > placed.collider;
      });
      moving_.insert(after, {placed.collider, collider.mover, mover.reach()});
      const auto index = static_cast<std::uint32_t>(box);
      mobile_boxes_.insert(std::lower_bound(mobile_boxes_.begin(), mobile_boxes_.end(), index),
                           index);
    }
  }
  placed.present = true;
  scene_.put(placed.collider, place, Direction::of(pose.heading_rad));
}

}  // namespace elsie::physics

extern "C" __attribute__((visibility("default"))) elsie::physics::Engine* elsie_make_engine(
    const elsie::world::Arena& arena, const elsie::world::Physics& physics) {
  return new elsie::physics::PlanarEngine(arena, physics);
}

extern "C" {
__attribute__((
    visibility("default"))) extern const elsie::physics::EngineInterface elsie_engine_interface{};
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
