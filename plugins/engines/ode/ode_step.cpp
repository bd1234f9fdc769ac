// The steps of the engine on ODE.
#include <cmath>
#include <string>
#include <utility>

#include "elsie/base/fnv1a.h"

#include "checks.h"
#include "ode_engine.h"

namespace elsie::physics {
namespace {

// When ODE's solver gives up, the step is repeated with contacts softer by this factor, and by more
// if necessary.
constexpr double kSofter = 3.0;
constexpr int kMostAttempts = 4;

}  // namespace

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
  for (const Grip& grip : bodies_.grips.all()) {
    all.add(std::uint64_t{grip.robot});
    all.add(std::uint64_t{grip.box});
  }
  return all.value();
}

}  // namespace elsie::physics
