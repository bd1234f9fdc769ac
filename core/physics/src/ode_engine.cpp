// The engine on ODE: bodies are added, contacts are found, ODE solves.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"

#include "checks.h"
#include "narrow_phase.h"
#include "ode_contacts.h"
#include "ode_handles.h"
#include "ode_robot.h"
#include "scene.h"
#include "state_hash.h"

namespace elsie::physics {
namespace {

// How much further a body may come in a step than at its present speed, by being accelerated.
constexpr double kSlack = 1e-3;  // m

// Bodies that were put into each other, or squeezed, come apart no faster than this.
constexpr double kMaxCorrectingSpeed = 0.5;  // m/s

// Where ODE's solver gives up, the step is taken again with contacts softer by this factor, and by
// more if need be.
constexpr double kSofter = 3.0;
constexpr int kMostAttempts = 4;

class OdeEngine final : public Engine {
 public:
  OdeEngine(const world::Arena& arena, const world::Physics& physics);

  std::size_t add_robot(const world::RobotBody& body, const Pose& pose, double z,
                        std::span<const world::Segment> segments) override;
  std::size_t add_box(const world::Box& box) override;
  void remove_box(std::size_t box) override;
  void place_robot(std::size_t robot, const Pose& pose, double z) override;
  void set_wheel_rates(std::size_t robot, const MotorCommand& rates) override;
  void drive_box(std::size_t box, const Vector2& position, const Vector2& velocity) override;
  void step() override;

  RobotState robot(std::size_t robot) const override { return robots_.at(robot).state(); }
  std::size_t segments(std::size_t robot) const override {
    return robots_.at(robot).segments().size();
  }
  SegmentState segment(std::size_t robot, std::size_t segment) const override {
    return robots_.at(robot).segments().at(segment).state();
  }
  Frame box(std::size_t box) const override;
  bool has_box(std::size_t box) const override { return boxes_.at(box).present; }
  std::span<const Touch> touches() const override { return touches_; }
  std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction, double max_range,
                                 std::size_t except) const override {
    return scene_.cast_ray(origin, direction, max_range, except);
  }
  bool anything_in(const Pyramid& pyramid, std::size_t except) const override {
    return scene_.anything_in(pyramid, except);
  }
  std::uint64_t hash_state(std::uint64_t hash) const override;

 private:
  struct BoxBody {
    world::BoxKind kind = world::BoxKind::fixed;
    bool present = true;
    Scene::Id id = 0;
    dBodyID body = nullptr;  // none for one that stands fast
    OdeGeom geom;
    OrientedBox shape;
    // Of a moving box: where it is at the end of the next step.
    bool driven = false;
    Vector3 target;
  };

  struct BodyState {
    dBodyID body = nullptr;
    dReal position[3], orientation[4], velocity[3], turning[3];
  };

  static bool is_mobile(const BoxBody& box) {
    return box.kind == world::BoxKind::dynamic || box.kind == world::BoxKind::moving;
  }
  std::size_t add_upright(std::vector<BoxBody>& list, BodyKind kind, world::BoxKind box_kind,
                          const OrientedBox& shape, double mass, bool sensed);
  BoxBody& box_of(const Body& body) {
    return body.kind == BodyKind::wall ? walls_[body.index] : boxes_[body.index];
  }
  bool is_mobile(const Body& body) {
    return body.kind == BodyKind::robot || is_mobile(box_of(body));
  }
  void take_step();
  void remember();
  void go_back();
  void start_moving_boxes();
  void find_contacts();
  bool meet(Scene::Id a, Scene::Id b);
  bool meet_own(const OdeRobot& robot, std::size_t a, std::size_t b);
  void place_in_scene(std::size_t robot);
  void settle();
  void settle_box(BoxBody& box, std::size_t index);
  [[noreturn]] void fail(const std::string& what) const;

  world::Physics physics_;
  double time_ = 0.0;
  OdeWorld world_;
  // Geometry goes before the world with the bodies that it is attached to.
  OdeContacts contacts_;
  OdeGeom floor_;
  Scene scene_;
  std::vector<OdeRobot> robots_;
  std::vector<std::vector<Scene::Id>> robot_ids_;  // of a robot's vehicles
  std::vector<BoxBody> boxes_;
  std::vector<BoxBody> walls_;
  std::vector<Touch> touches_;
  std::vector<BodyState> before_;     // this step
  std::vector<Scene::Id> mobile_;     // ascending
  std::vector<Scene::Id> neighbors_;  // of the one at hand; kept to reuse its memory
};

OdeEngine::OdeEngine(const world::Arena& arena, const world::Physics& physics)
    : physics_((check(arena, physics), physics)),
      contacts_(world_.get(), physics),
      floor_(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0)),
      scene_(arena) {
  dWorldSetGravity(world_.get(), 0.0, 0.0, physics.gravity);
  // Joints take these over when they are made.
  dWorldSetERP(world_.get(), physics.effective_erp());
  dWorldSetCFM(world_.get(), physics.effective_cfm());
  dWorldSetContactMaxCorrectingVel(world_.get(), kMaxCorrectingSpeed);
  if (!arena.walls) return;
  // Outside of the area, the ones along x long enough to close the corners: east, north, west,
  // south.
  const double t = arena.wall_thickness, h = arena.wall_height;
  const double x = 0.5 * (arena.length + t), y = 0.5 * (arena.width + t);
  const std::array<OrientedBox, 4> walls{
      upright_box({x, 0.0, 0.0}, 0.0, t, arena.width, h),
      upright_box({0.0, y, 0.0}, 0.0, arena.length + 2.0 * t, t, h),
      upright_box({-x, 0.0, 0.0}, 0.0, t, arena.width, h),
      upright_box({0.0, -y, 0.0}, 0.0, arena.length + 2.0 * t, t, h)};
  for (const OrientedBox& wall : walls) {
    add_upright(walls_, BodyKind::wall, world::BoxKind::fixed, wall, 0.0, true);
  }
}

std::size_t OdeEngine::add_robot(const world::RobotBody& body, const Pose& pose, double z,
                                 std::span<const world::Segment> segments) {
  check(body, pose, z);
  check(body, segments);
  prepare_ode();
  const std::size_t index = robots_.size();
  robots_.emplace_back(world_.get(), body, segments, pose, z);
  std::vector<Scene::Id>& ids = robot_ids_.emplace_back();
  for (std::size_t vehicle = 0; vehicle < robots_[index].vehicle_count(); ++vehicle) {
    ids.push_back(scene_.add({BodyKind::robot, index}, true, vehicle));
    mobile_.push_back(ids.back());
  }
  place_in_scene(index);
  return index;
}

void OdeEngine::place_robot(std::size_t robot, const Pose& pose, double z) {
  check(pose, z);
  robots_.at(robot).put(pose, z);
  place_in_scene(robot);
}

void OdeEngine::place_in_scene(std::size_t robot) {
  for (std::size_t vehicle = 0; vehicle < robot_ids_[robot].size(); ++vehicle) {
    robots_[robot].place_in(scene_, vehicle, robot_ids_[robot][vehicle], physics_.step);
  }
}

std::size_t OdeEngine::add_upright(std::vector<BoxBody>& list, BodyKind kind,
                                   world::BoxKind box_kind, const OrientedBox& shape, double mass,
                                   bool sensed) {
  const std::size_t index = list.size();
  BoxBody& made = list.emplace_back();
  made.kind = box_kind;
  made.shape = shape;
  made.geom.reset(dCreateBox(nullptr, 2.0 * shape.half.x, 2.0 * shape.half.y, 2.0 * shape.half.z));
  const double heading = std::atan2(shape.axes[0].y, shape.axes[0].x);
  const dQuaternion facing{std::cos(0.5 * heading), 0.0, 0.0, std::sin(0.5 * heading)};
  if (is_mobile(made)) {
    made.body = dBodyCreate(world_.get());
    if (box_kind == world::BoxKind::dynamic) {
      dMass box_mass;
      dMassSetBoxTotal(&box_mass, mass, 2.0 * shape.half.x, 2.0 * shape.half.y, 2.0 * shape.half.z);
      dBodySetMass(made.body, &box_mass);
      dBodySetFiniteRotationMode(made.body, 1);
    } else {
      dBodySetKinematic(made.body);
    }
    dGeomSetBody(made.geom.get(), made.body);
    dBodySetPosition(made.body, shape.center.x, shape.center.y, shape.center.z);
    dBodySetQuaternion(made.body, facing);
  } else {
    dGeomSetPosition(made.geom.get(), shape.center.x, shape.center.y, shape.center.z);
    dGeomSetQuaternion(made.geom.get(), facing);
  }
  made.id = scene_.add({kind, index}, sensed);
  if (is_mobile(made)) mobile_.push_back(made.id);
  scene_.place_box(made.id, made.shape, is_mobile(made) ? kSlack : 0.0);
  return index;
}

std::size_t OdeEngine::add_box(const world::Box& box) {
  check(box);
  prepare_ode();
  return add_upright(boxes_, BodyKind::box, box.kind,
                     upright_box({box.x, box.y, box.z}, radians(box.heading_deg), box.length,
                                 box.width, box.height),
                     box.mass, box.seen_by_range_sensors);
}

void OdeEngine::remove_box(std::size_t box) {
  BoxBody& gone = boxes_.at(box);
  if (!gone.present) return;
  gone.present = false;
  scene_.remove(gone.id);
  std::erase(mobile_, gone.id);
  gone.geom.reset();
  if (gone.body) dBodyDestroy(gone.body);
  gone.body = nullptr;
}

void OdeEngine::set_wheel_rates(std::size_t robot, const MotorCommand& rates) {
  require(rates.is_finite(), "The wheel rates that a robot is to hold must be finite.");
  robots_.at(robot).set_wheel_rates(rates);
}

void OdeEngine::drive_box(std::size_t box, const Vector2& position, const Vector2& velocity) {
  BoxBody& driven = boxes_.at(box);
  require(driven.kind == world::BoxKind::moving, "Only a moving box can be driven.");
  require(std::isfinite(position.x + position.y + velocity.x + velocity.y),
          "The position and velocity of a moving box must be finite.");
  if (!driven.present) return;
  driven.driven = true;
  driven.target = {position.x, position.y, driven.shape.center.z};
  dBodySetLinearVel(driven.body, velocity.x, velocity.y, 0.0);
}

Frame OdeEngine::box(std::size_t box) const {
  const BoxBody& asked = boxes_.at(box);
  const auto& [forward, left, up] = asked.shape.axes;
  return {asked.shape.center - asked.shape.half.z * up, forward, left, up};
}

void OdeEngine::step() {
  prepare_ode();
  try {
    take_step();
  } catch (const OdeFailure& failure) {
    fail("its solver stopped (" + std::string(failure.what()) + ")");
  }
}

void OdeEngine::take_step() {
  start_moving_boxes();
  for (OdeRobot& robot : robots_) robot.stop_at_limits(physics_.step);
  remember();
  for (int attempt = 1;; ++attempt) {
    find_contacts();
    const bool solved = world_.step(physics_.step);
    contacts_.clear(solved ? 1.0 : std::pow(kSofter, attempt));
    if (solved || attempt > kMostAttempts) break;
    go_back();
  }
  contacts_.clear();
  time_ += physics_.step;
  settle();
}

void OdeEngine::remember() {
  before_.clear();
  const auto add = [&](dBodyID body) {
    BodyState& state = before_.emplace_back();
    state.body = body;
    std::copy_n(dBodyGetPosition(body), 3, state.position);
    std::copy_n(dBodyGetQuaternion(body), 4, state.orientation);
    std::copy_n(dBodyGetLinearVel(body), 3, state.velocity);
    std::copy_n(dBodyGetAngularVel(body), 3, state.turning);
  };
  for (const OdeRobot& robot : robots_) robot.for_each_body(add);
  for (const BoxBody& box : boxes_) {
    if (box.body) add(box.body);
  }
}

void OdeEngine::go_back() {
  for (const BodyState& state : before_) {
    dBodySetPosition(state.body, state.position[0], state.position[1], state.position[2]);
    dBodySetQuaternion(state.body, state.orientation);
    dBodySetLinearVel(state.body, state.velocity[0], state.velocity[1], state.velocity[2]);
    dBodySetAngularVel(state.body, state.turning[0], state.turning[1], state.turning[2]);
  }
}

void OdeEngine::start_moving_boxes() {
  for (BoxBody& box : boxes_) {
    if (!box.present || box.kind != world::BoxKind::moving) continue;
    if (!box.driven) {
      dBodySetLinearVel(box.body, 0.0, 0.0, 0.0);
      continue;
    }
    // Back by the way of this step, so that it arrives with it.
    const Vector3 velocity = to_vector(dBodyGetLinearVel(box.body));
    box.shape.center = box.target - physics_.step * velocity;
    dBodySetPosition(box.body, box.shape.center.x, box.shape.center.y, box.shape.center.z);
    const double speed = std::sqrt(dot(velocity, velocity));
    scene_.place_box(box.id, box.shape, physics_.step * speed + kSlack);
  }
}

void OdeEngine::find_contacts() {
  for (const OdeRobot& robot : robots_) robot.meet_floor(contacts_, floor_.get());
  for (const BoxBody& box : boxes_) {
    if (box.present && box.kind == world::BoxKind::dynamic) {
      contacts_.box_on_floor(box.body, box.shape);
    }
  }
  touches_.clear();
  for (const Scene::Id id : mobile_) {
    scene_.neighbors(id, neighbors_);
    for (const Scene::Id other : neighbors_) {
      const Body a = scene_.body(id), b = scene_.body(other);
      if (other < id && is_mobile(b)) continue;  // met already
      if (meet(id, other)) touches_.push_back(a < b ? Touch{a, b} : Touch{b, a});
    }
  }
  std::sort(touches_.begin(), touches_.end(),
            [](const Touch& x, const Touch& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  // Several of a robot's vehicles may touch the same body.
  touches_.erase(
      std::unique(touches_.begin(), touches_.end(),
                  [](const Touch& x, const Touch& y) { return x.a == y.a && x.b == y.b; }),
      touches_.end());
}

bool OdeEngine::meet(Scene::Id first, Scene::Id second) {
  const Body a = scene_.body(first), b = scene_.body(second);
  const auto solid = [](const BoxBody& box) {
    return Solid{box.body, box.geom.get(), SolidKind::box, box.shape};
  };
  const auto vehicle = [this](Scene::Id id) {
    return robots_[scene_.body(id).index].vehicle(scene_.part(id));
  };
  if (a.kind == BodyKind::robot && b.kind == BodyKind::robot) {
    if (a == b) return meet_own(robots_[a.index], scene_.part(first), scene_.part(second));
    return meet_vehicles(contacts_, vehicle(first), vehicle(second));
  }
  if (a.kind == BodyKind::robot) {
    return meet_vehicle_and_box(contacts_, vehicle(first), solid(box_of(b)));
  }
  if (b.kind == BodyKind::robot) {
    return meet_vehicle_and_box(contacts_, vehicle(second), solid(box_of(a)));
  }
  const BoxBody &box_a = box_of(a), &box_b = box_of(b);
  const bool can_give =
      box_a.kind == world::BoxKind::dynamic || box_b.kind == world::BoxKind::dynamic;
  return can_give && meet_solids(contacts_, solid(box_a), solid(box_b));
}

// Neighbours are kept apart by the limits of their joint. Nobody is told that a robot touches
// itself.
bool OdeEngine::meet_own(const OdeRobot& robot, std::size_t a, std::size_t b) {
  if (std::max(a, b) - std::min(a, b) > 1) {
    meet_vehicles(contacts_, robot.vehicle(a), robot.vehicle(b));
  }
  return false;
}

void OdeEngine::settle() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (!robots_[i].settle(physics_.step))
      fail("the state of robot " + std::to_string(i) + " is no longer finite");
    place_in_scene(i);
  }
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (boxes_[i].present && is_mobile(boxes_[i])) settle_box(boxes_[i], i);
  }
}

void OdeEngine::settle_box(BoxBody& box, std::size_t index) {
  if (box.kind == world::BoxKind::moving) {
    if (!box.driven) return;
    box.driven = false;
    box.shape.center = box.target;
    dBodySetPosition(box.body, box.target.x, box.target.y, box.target.z);
    scene_.place_box(box.id, box.shape, scene_.reach(box.id));
    return;
  }
  const dReal* r = dBodyGetRotation(box.body);
  box.shape.center = to_vector(dBodyGetPosition(box.body));
  box.shape.axes = {{{r[0], r[4], r[8]}, {r[1], r[5], r[9]}, {r[2], r[6], r[10]}}};
  const Vector3 v = to_vector(dBodyGetLinearVel(box.body));
  const Vector3 w = to_vector(dBodyGetAngularVel(box.body));
  const Vector3& half = box.shape.half;
  const double speed = std::sqrt(dot(v, v)) + (half.x + half.y + half.z) * std::sqrt(dot(w, w));
  const Vector3& c = box.shape.center;
  if (!std::isfinite(c.x + c.y + c.z + r[0] + r[5] + r[10] + speed)) {
    fail("the state of box " + std::to_string(index) + " is no longer finite");
  }
  scene_.place_box(box.id, box.shape, physics_.step * speed + kSlack);
}

void OdeEngine::fail(const std::string& what) const {
  throw std::runtime_error("The physics became unstable after " + std::to_string(time_) +
                           " s: " + what +
                           ". A smaller step, a larger cfm, or less extreme masses, torques and "
                           "speeds may help.");
}

std::uint64_t OdeEngine::hash_state(std::uint64_t hash) const {
  StateHash all(hash);
  for (const OdeRobot& robot : robots_) {
    robot.for_each_body([&](dBodyID body) { all.add_body(body); });
  }
  for (const BoxBody& box : boxes_) {
    all.add(std::uint64_t{box.present});
    if (!box.present) continue;
    if (box.body) {
      all.add_body(box.body);
    } else {
      all.add(dGeomGetPosition(box.geom.get()), 3);
      dQuaternion facing;
      dGeomGetQuaternion(box.geom.get(), facing);
      all.add(facing, 4);
    }
  }
  return all.value();
}

}  // namespace

std::unique_ptr<Engine> make_ode_engine(const world::Arena& arena, const world::Physics& physics) {
  return std::make_unique<OdeEngine>(arena, physics);
}

}  // namespace elsie::physics
