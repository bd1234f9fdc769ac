// The steps of the planar engine: bodies meet, and move along their arcs.
#include <algorithm>
#include <cmath>
#include <exception>
#include <tuple>

#include "elsie/base/fnv1a.h"
#include "elsie/physics/failure.h"

#include "checks.h"
#include "planar_engine.h"

namespace elsie::physics {
namespace {

// The additional distance that a body may move in a step because it is accelerated.
constexpr double kSlack = 1e-4;  // m

// Bodies in the share of a thread; fewer are not worth waking it.
constexpr std::size_t kLeastMovers = 32;

Frame frame_at(const Vector2& place, double z, const Direction& ahead) {
  return {{place.x, place.y, z}, {ahead.c, ahead.s, 0.0}, {-ahead.s, ahead.c, 0.0}, {0, 0, 1}};
}

}  // namespace

void PlanarEngine::set_joints(std::size_t robot, std::span<const JointSetting> settings) {
  PlanarRobot& set = robots_.at(robot);
  check(settings, set.joints().size());
  bounds_.add_robot_speed(set.lever() * set.set_joints(settings, movers_));
}

void PlanarEngine::drive_obstacle(std::size_t box, const Vector2& position,
                                  const Vector2& velocity) {
  BoxBody& driven = boxes_.at(box);
  check_drive(driven.kind, position, velocity);
  if (!driven.present) return;
  driven.driven = true;
  driven.target = position;
  bounds_.add_moving_speed(std::hypot(velocity.x, velocity.y));
  mover_of_box(driven).drive(velocity);
}

RobotState PlanarEngine::robot(std::size_t robot) const {
  const Mover& mover = movers_[robots_.at(robot).first()];
  const Twist velocity = mover.velocity_of_origin();
  const Vector2& at = mover.place();
  return {frame_at(at, 0.0, mover.ahead()),
          {at.x, at.y, mover.heading_rad()},
          velocity.x,
          velocity.y,
          velocity.turn};
}

SegmentState PlanarEngine::segment(std::size_t robot, std::size_t segment) const {
  const PlanarRobot& asked = robots_.at(robot);
  const Hinge& hinge = asked.hinge(segment);
  const Mover& mover = movers_[hinge.behind];
  const Vector2& at = mover.place();
  return {frame_at(at, 0.0, mover.ahead()), {at.x, at.y, mover.heading_rad()}, hinge.yaw_rad, 0.0};
}

BodyMotion PlanarEngine::motion(std::size_t robot) const {
  const Mover& mover = movers_[robots_.at(robot).first()];
  const Twist velocity = mover.ahead().turn(mover.velocity_of_origin());
  return {{velocity.x, velocity.y, 0.0}, {0.0, 0.0, velocity.turn}};
}

void PlanarEngine::note_contacts() {
  for (const Contact& contact : pipeline_.contacts()) {
    if (contact.gap > kTouching && contact.normal_impulse <= 0.0) continue;
    const Body &a = colliders_[contact.collider_a].body, &b = colliders_[contact.collider_b].body;
    if (a == b) continue;
    if (contact_watch_.watches(a)) note_contact(contact, true);
    if (contact_watch_.watches(b)) note_contact(contact, false);
  }
}

void PlanarEngine::note_contact(const Contact& contact, bool of_a) {
  const Collider& a = colliders_[contact.collider_a];
  const Collider& b = colliders_[contact.collider_b];
  const Outline& first = (*a.solids)[contact.key.solid_of_a()].outline;
  const Outline& second = (*b.solids)[contact.key.solid_of_b()].outline;
  // Prisms meet all the way up.
  const double height =
      0.5 * (std::max(first.bottom, second.bottom) + std::min(first.top, second.top));
  const Vector2& normal = contact.normal;
  const double pressing = contact.normal_impulse, rubbing = contact.friction_impulse;
  const double side = of_a ? 1.0 : -1.0;
  const Collider &own = of_a ? a : b, &other = of_a ? b : a;
  contact_watch_.note(own.body.index, {contact.key.a, contact.key.b, contact.key.feature},
                      {own.vehicle,
                       other.body,
                       {contact.at.x, contact.at.y, height},
                       {side * normal.x, side * normal.y, 0.0},
                       {side * (pressing * normal.x - rubbing * normal.y),
                        side * (pressing * normal.y + rubbing * normal.x), 0.0}});
}

Frame PlanarEngine::obstacle(std::size_t box) const {
  const BoxBody& asked = boxes_.at(box);
  const Collider& collider = colliders_[asked.collider];
  if (collider.mover == Contact::kFixed) {
    return frame_at(scene_.place_of(asked.collider), asked.bottom, scene_.ahead_of(asked.collider));
  }
  const Mover& mover = movers_[collider.mover];
  return frame_at(mover.place(), asked.bottom, mover.ahead());
}

void PlanarEngine::start_moving_boxes() {
  for (const std::uint32_t index : mobile_boxes_) {
    BoxBody& box = boxes_[index];
    if (box.kind != world::ObstacleKind::moving) continue;
    Mover& mover = mover_of_box(box);
    if (!box.driven) {
      mover.drive({});
      continue;
    }
    // Moved back by the distance of this step, so that the box arrives with it.
    const double step = parts_ * physics_.step;
    const Twist velocity = mover.ahead().turn(mover.velocity());
    const Vector2& at = mover.place();
    mover.shift({box.target.x - step * velocity.x - at.x, box.target.y - step * velocity.y - at.y});
  }
}

/// Puts those that were driven to their targets.
void PlanarEngine::stop_moving_boxes() {
  for (const std::uint32_t index : mobile_boxes_) {
    BoxBody& box = boxes_[index];
    if (!box.driven) continue;
    box.driven = false;
    Mover& mover = mover_of_box(box);
    mover.shift({box.target.x - mover.place().x, box.target.y - mover.place().y});
    scene_.move(box.collider, mover.place(), mover.ahead(), moves_.front());
  }
}

/// Returns how far two bodies may come nearer in this part of the step, m.
double PlanarEngine::begin_movers() {
  std::fill(fastest_.begin(), fastest_.end(), 0.0);
  pool_->divide(moving_.size(), kLeastMovers, [&](const base::ThreadPool::Share& share) {
    double& fastest = fastest_[share.thread];
    for (std::size_t i = share.first; i < share.end; ++i) {
      Mover& mover = movers_[moving_[i].mover];
      mover.begin();
      const Twist& v = mover.velocity();
      const double square = v.x * v.x + v.y * v.y;
      const double edge = moving_[i].reach * std::abs(v.turn);
      fastest =
          std::max(fastest, 2.0 * (square + edge * edge));  // the square of their sum, or more
    }
  });
  const double fastest = *std::max_element(fastest_.begin(), fastest_.end());
  return 2.0 * physics_.step * (1.0 + physics_.bounce) * std::sqrt(fastest) + kSlack;
}

void PlanarEngine::step() {
  moves_.resize(pool_->threads());
  fastest_.resize(pool_->threads());
  start_moving_boxes();
  pipeline_.forget_touches();
  contact_watch_.begin_step();
  const double from = time_;
  for (int part = 1; part <= parts_; ++part) {
    time_ = from + part * physics_.step;
    move_on();
  }
  stop_moving_boxes();
  scene_.settle(moves_);
  if (contact_watch_.is_used()) contact_watch_.end_step();
}

/// A part of the step.
void PlanarEngine::move_on() {
  hinges_.clear();
  for (const std::uint32_t i : jointed_) {
    robots_[i].begin(physics_.step, movers_);
    for (Hinge& hinge : robots_[i].hinges()) hinges_.push_back(&hinge);
  }
  begin_grips();
  pipeline_.find(moving_, begin_movers(), *pool_);
  pipeline_.solve(hinges_, *pool_);
  if (contact_watch_.is_used()) note_contacts();
  settle();
  fail_if_pressed();
}

inline bool PlanarEngine::is_well(const Mover& mover, double limit, bool stays_within) const {
  const Vector2& at = mover.place();
  const Twist& v = mover.velocity();
  return v.x * v.x + v.y * v.y <= limit * limit && std::isfinite(at.x + at.y + v.turn) &&
         (!stays_within || bounds_.within_walls({at.x, at.y, 0.0}));
}

void PlanarEngine::place_in_scene(std::size_t robot, PlanarScene::Moves& moves) {
  const PlanarRobot& made = robots_[robot];
  std::uint32_t collider = robot_bodies_[robot].first_collider;
  made.point_shapes();
  for (const Mover& mover : std::span(movers_).subspan(made.first(), made.vehicles())) {
    scene_.move(collider++, mover.place(), mover.ahead(), moves);
  }
}

void PlanarEngine::settle_robot(std::size_t i, double limit, PlanarScene::Moves& moves) {
  PlanarRobot& robot = robots_[i];
  const auto own = std::span(movers_).subspan(robot.first(), robot.vehicles());
  for (Mover& mover : own) mover.advance(physics_.step);
  robot.settle(movers_);
  place_in_scene(i, moves);
  const bool stays_within = robot_bodies_[i].stays_within;
  for (std::size_t k = 0; k < own.size(); ++k) {
    if (is_well(own[k], limit, stays_within)) continue;
    fail(own[k], stays_within, {BodyKind::robot, i},
         k > 0 ? std::optional<std::size_t>(k - 1) : std::nullopt);
  }
}

/// Moves all bodies.
void PlanarEngine::settle() {
  const double limit = bounds_.most_speed();
  std::exception_ptr failed;
  const auto try_to = [&](const auto& work) {
    try {
      work();
    } catch (const PhysicsFailure&) {
      if (!failed) failed = std::current_exception();
    }
  };
  const auto settle_robots = [&](const base::ThreadPool::Share& share) {
    std::exception_ptr failure;  // the others are moved, too
    for (std::size_t i = share.first; i < share.end; ++i) {
      try {
        settle_robot(i, limit, moves_[share.thread]);
      } catch (const PhysicsFailure&) {
        if (!failure) failure = std::current_exception();
      }
    }
    if (failure) std::rethrow_exception(failure);
  };
  try_to([&] { pool_->divide(robots_.size(), kLeastMovers, settle_robots); });
  try_to([&] { settle_boxes(limit, moves_.front()); });
  settle_grips(moves_.front());
  scene_.settle(moves_);
  if (failed) std::rethrow_exception(failed);
}

void PlanarEngine::settle_boxes(double limit, PlanarScene::Moves& moves) {
  for (const std::uint32_t index : mobile_boxes_) {
    BoxBody& box = boxes_[index];
    Mover& mover = mover_of_box(box);
    mover.advance(physics_.step);
    if (box.kind == world::ObstacleKind::dynamic && !is_well(mover, limit, box.stays_within)) {
      fail(mover, box.stays_within, {BodyKind::obstacle, index}, std::nullopt);
    }
    scene_.move(box.collider, mover.place(), mover.ahead(), moves);
  }
}

void PlanarEngine::fail(const Mover& mover, bool stays_within, const Body& body,
                        std::optional<std::size_t> segment) const {
  const Vector2& at = mover.place();
  const Twist& v = mover.velocity();
  Failure failure;
  if (auto found = bounds_.check({at.x, at.y, 0.0}, {v.x, v.y, 0.0}, stays_within)) {
    failure = *found;
  } else {
    failure.kind = Failure::Kind::not_finite;
  }
  failure.body = body;
  failure.segment = segment;
  failure.time_s = time_;
  throw PhysicsFailure(failure);
}

/// Fails if a box that nothing stops leaves a body no room.
void PlanarEngine::fail_if_pressed() const {
  const auto presses = pipeline_.presses();
  if (presses.empty()) return;
  // The same one, whatever the order in which they were found.
  const auto rank = [this](const CollisionPipeline::Press& each) {
    const Collider& collider = colliders_[each.body];
    return std::tie(collider.body, collider.vehicle, colliders_[each.box].body);
  };
  const CollisionPipeline::Press& press =
      *std::min_element(presses.begin(), presses.end(),
                        [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  const Collider& collider = colliders_[press.body];
  const Vector2& at = movers_[collider.mover].place();
  Failure failure;
  failure.kind = Failure::Kind::pressed;
  failure.body = collider.body;
  if (collider.vehicle > 0) failure.segment = collider.vehicle - 1;
  failure.presser = colliders_[press.box].body;
  failure.place = {at.x, at.y, 0.0};
  failure.time_s = time_;
  throw PhysicsFailure(failure);
}

std::uint64_t PlanarEngine::hash_state(std::uint64_t hash) const {
  base::Fnv1a all(hash);
  const auto add = [&](std::uint32_t id) {
    const Collider& collider = colliders_[id];
    const bool moves = collider.mover != Contact::kFixed;
    const Vector2& at = moves ? movers_[collider.mover].place() : scene_.place_of(id);
    const Direction& ahead = moves ? movers_[collider.mover].ahead() : scene_.ahead_of(id);
    for (const double number : {at.x, at.y, ahead.c, ahead.s}) all.add(number);
    if (!moves) return;
    const Twist& v = movers_[collider.mover].velocity();
    for (const double number : {v.x, v.y, v.turn}) all.add(number);
  };
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    for (std::uint32_t k = 0; k < robots_[i].vehicles(); ++k) {
      add(robot_bodies_[i].first_collider + k);
    }
    for (const JointSetting& joint : robots_[i].joints()) {
      all.add(joint.rate_rad_s);
      all.add(joint.angle_rad);
    }
  }
  for (const BoxBody& box : boxes_) {
    all.add(std::uint64_t{box.present});
    if (box.present) add(box.collider);
  }
  for (const Grip& grip : grips_) {
    all.add(std::uint64_t{grip.robot});
    all.add(std::uint64_t{grip.box});
  }
  return all.value();
}

}  // namespace elsie::physics
