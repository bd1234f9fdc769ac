// The engine on ODE: bodies are added, contacts are found, ODE solves.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "elsie/api/abi.h"
#include "elsie/base/fnv1a.h"
#include "elsie/physics/engine.h"
#include "elsie/physics/failure.h"
#include "elsie/world/engine_facts.h"
#include "elsie/world/parts.h"

#include "body_states.h"
#include "bounds.h"
#include "box_body.h"
#include "checks.h"
#include "contact_finder.h"
#include "islands.h"
#include "ode_handles.h"
#include "ode_robot.h"
#include "scene.h"
#include "softness.h"
#include "watches.h"

namespace elsie::physics {
namespace {

// The additional distance that a body may move in a step because it is accelerated.
constexpr double kSlack = 1e-3;  // m

// When ODE's solver gives up, the step is repeated with contacts softer by this factor, and by more
// if necessary.
constexpr double kSofter = 3.0;
constexpr int kMostAttempts = 4;

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

class OdeEngine final : public Engine {
 public:
  OdeEngine(const world::Arena& arena, const world::Physics& physics);

  std::size_t add_robot(const BodyPlan& plan, const Pose& pose, double z) override;
  std::size_t add_obstacle(const world::Obstacle& box) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot) override;
  std::size_t add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                           const Pose& pose) override;
  std::size_t add_obstacle_of(const Engine& other, std::size_t box,
                              const world::Obstacle& added) override;
  void go_on_from(const Engine& other) override;
  void remove_obstacle(std::size_t box) override;
  void place_robot(std::size_t robot, const Pose& pose, double z) override;
  void hold(std::size_t robot, std::size_t box) override;
  void let_go(std::size_t robot, std::size_t box) override;
  void place_obstacle(std::size_t box, const Pose& pose) override;
  void set_joints(std::size_t robot, std::span<const JointSetting> settings) override;
  std::span<const JointSetting> joints(std::size_t robot) const override {
    return bodies_.robots.at(robot).joints();
  }
  void drive_obstacle(std::size_t box, const Vector2& position, const Vector2& velocity) override;
  void work_with(base::ThreadPool& pool) override {
    pool_ = &pool;
    world_.work_with(pool);
  }
  void step() override;

  RobotState robot(std::size_t robot) const override { return bodies_.robots.at(robot).state(); }
  std::size_t segments(std::size_t robot) const override {
    return bodies_.robots.at(robot).vehicles().size() - 1;
  }
  SegmentState segment(std::size_t robot, std::size_t segment) const override {
    return bodies_.robots.at(robot).segment(segment);
  }
  Frame obstacle(std::size_t box) const override;
  bool has_obstacle(std::size_t box) const override { return bodies_.boxes.at(box).present; }
  std::span<const Touch> touches() const override { return finder_.touches(); }
  void watch_contacts(std::size_t robot) override {
    bodies_.robots.at(robot);
    contact_watch_.watch(robot);
  }
  std::span<const BodyContact> contacts(std::size_t robot) const override {
    bodies_.robots.at(robot);
    return contact_watch_.of(robot);
  }
  BodyMotion motion(std::size_t robot) const override;
  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const override {
    return bodies_.scene.cast_ray(origin, direction, max_range, except);
  }
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                 std::size_t except) const override {
    bodies_.scene.cast_rays(within, rays, surfaces, except);
  }
  bool anything_in(const Pyramid& pyramid, std::size_t except) const override {
    return bodies_.scene.anything_in(pyramid, except);
  }
  std::uint64_t hash_state(std::uint64_t hash) const override;
  GiveUps give_ups() const override { return give_ups_; }

 private:
  /// What a share of the robots does in a step.
  struct Share {
    BodyStates before;             // at the start of this step
    std::vector<Scene::Id> moved;  // to other cells of the scene
    std::optional<Failure> failure;
  };

  std::size_t add_upright(std::vector<BoxBody>& list, BodyKind kind, world::ObstacleKind box_kind,
                          const world::Fixture& fixture, double mass, bool sensed);
  std::size_t enter_robot(double top);
  void take_watches(const OdeEngine& other, std::size_t robot);
  void take_step();
  template <class Work>
  void for_each_robot(const Work& work);
  void begin();
  void restore();
  void find_contacts(Islands::OdeTakes takes);
  void start_moving_boxes();
  void place_in_scene(std::size_t robot);
  void settle();
  void settle_robot(std::size_t robot, Share& share);
  void settle_box(BoxBody& box, std::size_t index);
  std::optional<Failure> judge(const Vector3& middle, const Vector3& velocity, bool stays_within,
                               const Body& body,
                               std::optional<std::size_t> segment = std::nullopt) const;
  [[noreturn]] void fail(Failure failure) const;

  world::Physics physics_;
  double time_ = 0.0;
  base::ThreadPool alone_;
  base::ThreadPool* pool_ = &alone_;
  OdeWorld world_;
  // Geometry is destroyed before the world with the bodies that it is attached to.
  ContactFinder finder_;
  OdeBodies bodies_;
  std::vector<std::vector<Scene::Id>> robot_ids_;  // of a robot's vehicles
  std::vector<Share> shares_;
  BodyStates boxes_before_;  // at the start of this step
  Islands islands_;
  Bounds bounds_;
  ContactWatch contact_watch_;
  GiveUps give_ups_;
  std::vector<bool> stay_within_;  // within the arena's walls: each robot
};

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
  std::erase_if(bodies_.grips, [&](const Grip& grip) { return grip.box == box; });
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

void OdeEngine::hold(std::size_t robot, std::size_t box) {
  BoxBody& held = bodies_.boxes.at(box);
  check_hold(held.kind, held.present, held.holders, held.hands);
  prepare_ode();
  const dBodyID chassis = bodies_.robots.at(robot).vehicles().front().chassis();
  const auto place = std::find_if(
      bodies_.grips.begin(), bodies_.grips.end(),
      [&](const Grip& grip) { return std::tie(grip.box, grip.robot) >= std::tie(box, robot); });
  require(place == bodies_.grips.end() || place->box != box || place->robot != robot,
          "The robot holds the box already.");
  bodies_.grips.insert(place, Grip(world_.get(), robot, chassis, box, held.body, held.hands > 1));
  ++held.holders;
  held.take_footing();
}

void OdeEngine::let_go(std::size_t robot, std::size_t box) {
  const auto is_it = [&](const Grip& grip) { return grip.box == box && grip.robot == robot; };
  if (std::erase_if(bodies_.grips, is_it) == 0) return;
  --bodies_.boxes[box].holders;
  bodies_.boxes[box].take_footing();
}

void OdeEngine::set_joints(std::size_t robot, std::span<const JointSetting> settings) {
  OdeRobot& set = bodies_.robots.at(robot);
  check(settings, set.joints().size());
  set.set_joints(settings);
  bounds_.add_robot_speed(set.most_speed(settings));
}

void OdeEngine::drive_obstacle(std::size_t box, const Vector2& position, const Vector2& velocity) {
  BoxBody& driven = bodies_.boxes.at(box);
  check_drive(driven.kind, position, velocity);
  if (!driven.present) return;
  driven.driven = true;
  bounds_.add_moving_speed(std::hypot(velocity.x, velocity.y));
  driven.target = {position.x, position.y, driven.shape.center.z};
  dBodySetLinearVel(driven.body, velocity.x, velocity.y, 0.0);
}

Frame OdeEngine::obstacle(std::size_t box) const { return bodies_.boxes.at(box).frame(); }

void OdeEngine::step() {
  prepare_ode();
  try {
    take_step();
  } catch (const OdeFailure&) {
    fail({});
  }
}

void OdeEngine::take_step() {
  contact_watch_.begin_step();
  start_moving_boxes();
  begin();
  bool solved = false;
  for (int attempt = 1; attempt <= kMostAttempts + 1 && !solved; ++attempt) {
    find_contacts(Islands::OdeTakes::small_islands);
    solved = world_.step(physics_.step, bodies_.mobile.size());
    islands_.dissolve(solved ? 1.0 : std::pow(kSofter, attempt));
    if (!solved) restore();
    if (!solved && attempt == 1 && give_ups_.steps++ == 0) {
      give_ups_.first_s = time_ + physics_.step;
    }
  }
  if (!solved) {
    ++give_ups_.unsolved;
    islands_.dissolve();
    find_contacts(Islands::OdeTakes::nothing);
    islands_.dissolve();
  }
  islands_.step_others(*pool_);
  if (contact_watch_.is_used()) {
    finder_.note(bodies_, contact_watch_);
    contact_watch_.end_step();
  }
  time_ += physics_.step;
  settle();
}

/// Calls work(robot, share) for all robots; the pool does several shares at once.
template <class Work>
void OdeEngine::for_each_robot(const Work& work) {
  constexpr std::size_t size = ContactFinder::kBlock;
  const std::size_t robots = bodies_.robots.size();
  shares_.resize((robots + size - 1) / size);
  pool_->divide(shares_.size(), 1, [&](const base::ThreadPool::Share& some) {
    prepare_ode();
    const std::size_t end = std::min(robots, size * some.end);
    for (std::size_t i = size * some.first; i < end; ++i) work(i, shares_[i / size]);
  });
}

/// Prepares the bodies for a step, and remembers their states.
void OdeEngine::begin() {
  for (Share& share : shares_) share.before.clear();
  for_each_robot([&](std::size_t i, Share& share) {
    OdeRobot& robot = bodies_.robots[i];
    robot.begin_step(physics_.step);
    robot.for_each_body([&](dBodyID body) { share.before.add(body); });
  });
  boxes_before_.clear();
  for (const BoxBody& box : bodies_.boxes) {
    if (box.body) boxes_before_.add(box.body);
  }
}

void OdeEngine::restore() {
  for (const Share& share : shares_) share.before.restore();
  boxes_before_.restore();
}

void OdeEngine::find_contacts(Islands::OdeTakes takes) {
  finder_.find(bodies_, contact_watch_, *pool_);
  islands_.divide(finder_.found(), bodies_, takes);
}

BodyMotion OdeEngine::motion(std::size_t robot) const {
  const OdeVehicle& of = bodies_.robots.at(robot).vehicles().front();
  const Vector3 from_middle = of.frame().origin - of.solids().chassis.shape.center;
  return {of.velocity() + cross(of.turning(), from_middle), of.turning()};
}

void OdeEngine::start_moving_boxes() {
  for (BoxBody& box : bodies_.boxes) {
    if (!box.present || box.kind != world::ObstacleKind::moving) continue;
    if (!box.driven) {
      dBodySetLinearVel(box.body, 0.0, 0.0, 0.0);
      continue;
    }
    // Moved back by the distance of this step, so that the box arrives with it.
    const Vector3 velocity = to_vector(dBodyGetLinearVel(box.body));
    box.shape.center = box.target - physics_.step * velocity;
    dBodySetPosition(box.body, box.shape.center.x, box.shape.center.y, box.shape.center.z);
    const double speed = std::sqrt(dot(velocity, velocity));
    bodies_.scene.place_box(box.id, box.shape, physics_.step * speed + kSlack);
  }
}

void OdeEngine::settle() {
  for (Share& share : shares_) share.moved.clear();
  for_each_robot([&](std::size_t i, Share& share) { settle_robot(i, share); });
  for (Share& share : shares_) {
    if (share.failure) fail(*share.failure);
    for (const Scene::Id id : share.moved) bodies_.scene.enter(id);
  }
  for (std::size_t i = 0; i < bodies_.boxes.size(); ++i) {
    if (bodies_.boxes[i].present && bodies_.boxes[i].is_mobile()) settle_box(bodies_.boxes[i], i);
  }
}

void OdeEngine::settle_robot(std::size_t robot, Share& share) {
  OdeRobot& settled = bodies_.robots[robot];
  const Body body{BodyKind::robot, robot};
  const auto note = [&](const std::optional<Failure>& failure) {
    if (failure && !share.failure) share.failure = failure;
  };
  if (!settled.settle(physics_.step)) {
    Failure failure;
    failure.kind = Failure::Kind::not_finite;
    failure.body = body;
    return note(failure);
  }
  for (std::size_t k = 0; k < settled.vehicles().size(); ++k) {
    const Scene::Id id = robot_ids_[robot][k];
    if (settled.place_in(bodies_.scene, k, id, physics_.step)) share.moved.push_back(id);
    const dBodyID middle = settled.vehicles()[k].chassis();
    note(judge(to_vector(dBodyGetPosition(middle)), to_vector(dBodyGetLinearVel(middle)),
               stay_within_[robot], body, k > 0 ? std::optional(k - 1) : std::nullopt));
  }
}

void OdeEngine::settle_box(BoxBody& box, std::size_t index) {
  if (box.kind == world::ObstacleKind::moving) {
    if (!box.driven) return;
    box.driven = false;
    box.shape.center = box.target;
    dBodySetPosition(box.body, box.target.x, box.target.y, box.target.z);
    bodies_.scene.place_box(box.id, box.shape, bodies_.scene.reach(box.id));
    return;
  }
  box.read_shape();
  const Vector3& center = box.shape.center;
  const auto& [forward, left, up] = box.shape.axes;
  const double speed = box.most_speed();
  if (!std::isfinite(center.x + center.y + center.z + forward.x + left.y + up.z + speed)) {
    Failure failure;
    failure.kind = Failure::Kind::not_finite;
    failure.body = Body{BodyKind::obstacle, index};
    fail(failure);
  }
  if (const auto failure = judge(center, to_vector(dBodyGetLinearVel(box.body)), box.stays_within,
                                 {BodyKind::obstacle, index})) {
    fail(*failure);
  }
  bodies_.scene.place_box(box.id, box.shape, physics_.step * speed + kSlack);
}

std::optional<Failure> OdeEngine::judge(const Vector3& middle, const Vector3& velocity,
                                        bool stays_within, const Body& body,
                                        std::optional<std::size_t> segment) const {
  std::optional<Failure> failure = bounds_.check(middle, velocity, stays_within);
  if (failure) {
    failure->body = body;
    failure->segment = segment;
  }
  return failure;
}

void OdeEngine::fail(Failure failure) const {
  failure.time_s = time_;
  throw PhysicsFailure(failure);
}

std::uint64_t OdeEngine::hash_state(std::uint64_t hash) const {
  base::Fnv1a all(hash);
  for (const OdeRobot& robot : bodies_.robots) {
    robot.for_each_body([&](dBodyID body) { add_body(all, body); });
  }
  for (const BoxBody& box : bodies_.boxes) box.add_to(all);
  for (const Grip& grip : bodies_.grips) {
    all.add(std::uint64_t{grip.robot});
    all.add(std::uint64_t{grip.box});
  }
  return all.value();
}

}  // namespace
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
