// Adding bodies to the engine on ODE, changing and removing them.
#include "ode_engine.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/api/abi.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/parts.h"

#include "checks.h"
#include "softness.h"

namespace elsie::physics {
namespace {

/// Makes a body; an error from ODE means that the caller's data are wrong.
template <class Make>
void accept(const char* what, Make make) {
  try {
    make();
  } catch (const OdeFailure&) {
    throw std::invalid_argument("The masses and sizes of " + std::string(what) +
                                " are too small or too unlike: its moments of inertia are lost in "
                                "rounding.");
  }
}

}  // namespace

OdeEngine::OdeEngine(const world::Arena& arena, const world::Physics& physics)
    : physics_((check(arena, physics), physics)),
      world_(*pool_),
      finder_(physics),
      bodies_(arena),
      islands_(world_.get(), physics),
      bounds_(arena, physics) {
  dWorldSetGravity(world_.get(), 0.0, 0.0, physics.gravity);
  // Joints take these values when they are made.
  const Softness softness = softness_of(physics);
  dWorldSetERP(world_.get(), softness.erp);
  dWorldSetCFM(world_.get(), softness.cfm);
  dWorldSetContactMaxCorrectingVel(world_.get(), kMaxCorrectingSpeed);
  for (const world::Fixture& wall : world::walls_of(arena)) {
    add_upright(bodies_.walls, BodyKind::wall, world::ObstacleKind::fixed, wall, 0.0, true);
  }
}

std::size_t OdeEngine::add_robot(const BodyPlan& plan, const Pose& pose, double z) {
  world::check(plan);
  check(pose, z);
  prepare_ode();
  accept("a robot's body", [&] { bodies_.robots.emplace_back(world_.get(), plan, pose, z); });
  return enter_robot(z + bodies_.robots.back().height());
}

/// Enters the last of the robots. `top`: the height of its highest part, m.
std::size_t OdeEngine::enter_robot(double top) {
  const std::size_t index = bodies_.robots.size() - 1;
  std::vector<Scene::Id>& ids = robot_ids_.emplace_back();
  for (std::size_t vehicle = 0; vehicle < bodies_.robots[index].vehicles().size(); ++vehicle) {
    ids.push_back(bodies_.scene.add({BodyKind::robot, index}, true, vehicle));
    bodies_.mobile.push_back(ids.back());
  }
  islands_.add_robot(bodies_.robots[index]);
  stay_within_.push_back(bounds_.within_walls(bodies_.robots[index].state().frame.origin));
  bounds_.add_height(top);
  place_in_scene(index);
  return index;
}

std::size_t OdeEngine::add_robot_of(const Engine& other, std::size_t robot) {
  const auto& before = dynamic_cast<const OdeEngine&>(other);
  const OdeRobot& same = before.bodies_.robots.at(robot);
  prepare_ode();
  bodies_.robots.emplace_back(world_.get(), same);
  take_watches(before, robot);
  return enter_robot(std::max(0.0, same.state().frame.origin.z) + bodies_.robots.back().height());
}

/// The last robot is watched as it is in the other engine.
void OdeEngine::take_watches(const OdeEngine& other, std::size_t robot) {
  const std::size_t index = bodies_.robots.size() - 1;
  if (other.contact_watch_.watches(robot)) contact_watch_.watch(index);
}

std::size_t OdeEngine::add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                                    const Pose& pose) {
  const auto& before = dynamic_cast<const OdeEngine&>(other);
  const OdeRobot& same = before.bodies_.robots.at(robot);
  const double z = std::max(0.0, same.state().frame.origin.z);
  const std::size_t index = add_robot(plan, pose, z);
  bodies_.robots[index].push(same);
  take_watches(before, robot);
  place_in_scene(index);
  return index;
}

std::size_t OdeEngine::add_obstacle_of(const Engine& other, std::size_t box,
                                       const world::Obstacle& added) {
  const BoxBody& same = dynamic_cast<const OdeEngine&>(other).bodies_.boxes.at(box);
  const std::size_t index = add_obstacle(added);
  if (!same.present) {
    remove_obstacle(index);
    return index;
  }
  BoxBody& made = bodies_.boxes[index];
  if (made.body) {
    copy_state(same.body, made.body);
    if (made.kind == world::ObstacleKind::dynamic && !made.gives_way()) made.take_footing();
    made.shape = same.shape;
    made.stays_within =
        made.kind == world::ObstacleKind::dynamic && bounds_.within_walls(made.shape.center);
    bodies_.scene.place_box(made.id, made.shape, physics_.step * made.most_speed() + kSlack);
    bounds_.add_height(made.shape.center.z + made.shape.half.z);
  }
  return index;
}

void OdeEngine::go_on_from(const Engine& other) {
  const auto& before = dynamic_cast<const OdeEngine&>(other);
  time_ = before.time_;
  give_ups_ = before.give_ups_;
  bounds_.add(before.bounds_);
}

void OdeEngine::place_robot(std::size_t robot, const Pose& pose, double z) {
  check(pose, z);
  bodies_.robots.at(robot).put(pose, z);
  stay_within_[robot] = bounds_.within_walls(bodies_.robots[robot].state().frame.origin);
  bounds_.add_height(z + bodies_.robots[robot].height());
  place_in_scene(robot);
}

void OdeEngine::place_in_scene(std::size_t robot) {
  for (std::size_t vehicle = 0; vehicle < robot_ids_[robot].size(); ++vehicle) {
    const Scene::Id id = robot_ids_[robot][vehicle];
    if (bodies_.robots[robot].place_in(bodies_.scene, vehicle, id, physics_.step)) {
      bodies_.scene.enter(id);
    }
  }
}

std::size_t OdeEngine::add_upright(std::vector<BoxBody>& list, BodyKind kind,
                                   world::ObstacleKind box_kind, const world::Fixture& fixture,
                                   double mass, bool sensed) {
  const std::size_t index = list.size();
  BoxBody& made = list.emplace_back(world_.get(), box_kind, fixture, mass);
  made.id = bodies_.scene.add({kind, index}, sensed);
  bodies_.scene.shape_box(made.id, fixture.shape);
  if (made.is_mobile()) bodies_.mobile.push_back(made.id);
  bodies_.scene.place_box(made.id, made.shape, made.is_mobile() ? kSlack : 0.0);
  return index;
}

std::size_t OdeEngine::add_obstacle(const world::Obstacle& box) {
  check(box);
  prepare_ode();
  std::size_t index = 0;
  accept("a box", [&] {
    index = add_upright(bodies_.boxes, BodyKind::obstacle,
                        box.is_dynamic() ? world::ObstacleKind::dynamic : box.kind,
                        world::fixture_of(box), box.mass, box.seen_by_range_sensors);
  });
  BoxBody& made = bodies_.boxes[index];
  if (made.is_mobile()) islands_.add_obstacle(made.body);
  if (box.is_dynamic()) {
    made.stays_within = bounds_.within_walls(made.shape.center);
    made.hands = box.hands;
    if (box.hands > 1) made.take_footing();
    bounds_.add_height(box.z + box.height);
  }
  return index;
}

void OdeEngine::remove_obstacle(std::size_t box) {
  BoxBody& gone = bodies_.boxes.at(box);
  if (!gone.present) return;
  gone.present = false;
  gone.holders = 0;
  bodies_.grips.remove_box(box);
  bodies_.scene.remove(gone.id);
  std::erase(bodies_.mobile, gone.id);
  if (!gone.body) return;
  islands_.remove_obstacle(gone.body);
  dBodyDisable(gone.body);
}

void OdeEngine::place_obstacle(std::size_t box, const Pose& pose) {
  BoxBody& placed = bodies_.boxes.at(box);
  check(pose, 0.0);
  prepare_ode();
  placed.put(pose);
  if (!std::exchange(placed.present, true) && placed.body) {
    dBodyEnable(placed.body);
    islands_.add_obstacle(placed.body);
    std::vector<Scene::Id>& mobile = bodies_.mobile;
    mobile.insert(std::lower_bound(mobile.begin(), mobile.end(), placed.id), placed.id);
  }
  if (placed.kind == world::ObstacleKind::dynamic) placed.take_footing();
  if (placed.body) bounds_.add_height(placed.shape.center.z + placed.shape.half.z);
  placed.stays_within =
      placed.kind == world::ObstacleKind::dynamic && bounds_.within_walls(placed.shape.center);
  bodies_.scene.place_box(placed.id, placed.shape, placed.is_mobile() ? kSlack : 0.0);
}

void OdeEngine::hold(std::size_t robot, std::size_t box, const Vector2& at) {
  BoxBody& held = bodies_.boxes.at(box);
  check_hold(held.kind, held.present, held.holders, held.hands);
  prepare_ode();
  const dBodyID chassis = bodies_.robots.at(robot).vehicles().front().chassis();
  bodies_.grips.add(Grip(world_.get(), {robot, box, chassis, held.body},
                         held.hands > 1 ? std::optional(at) : std::nullopt));
  ++held.holders;
  held.take_footing();
}

void OdeEngine::let_go(std::size_t robot, std::size_t box) {
  if (!bodies_.grips.remove(robot, box)) return;
  --bodies_.boxes[box].holders;
  bodies_.boxes[box].take_footing();
}

}  // namespace elsie::physics

extern "C" __attribute__((visibility("default"))) elsie::physics::Engine* elsie_make_engine(
    const elsie::world::Arena& arena, const elsie::world::Physics& physics) {
  return new elsie::physics::OdeEngine(arena, physics);
}

extern "C" {
__attribute__((
    visibility("default"))) extern const elsie::physics::EngineInterface elsie_engine_interface{};
}

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);
