// Robots that hold boxes. A box that is held is joined to its robot by a hinge, and glides on the
// floor. The hinge does not turn, unless the box takes several hands.
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include "checks.h"
#include "planar_engine.h"

namespace elsie::physics {
namespace {

constexpr double kFree = 1e9;  // rad

/// A point of a body, in the world.
Vector2 point_of(const Mover& body, const Vector2& point) {
  return plus(body.place(), body.ahead().turn(point));
}

}  // namespace

Pose PlanarEngine::Grip::wanted(std::span<const Mover> movers) const {
  const Mover& own = movers[hinge.front];
  const Vector2 place = point_of(own, hinge.front_end);
  return {place.x, place.y, own.heading_rad() + turned_rad};
}

void PlanarEngine::hold(std::size_t robot, std::size_t box, const Vector2& at) {
  BoxBody& held = boxes_.at(box);
  check_hold(held.kind, held.present, held.holders, held.hands);
  Grip grip{box, robot, {}};
  grip.hinge.front = robots_.at(robot).first();
  grip.hinge.behind = colliders_[held.collider].mover;
  grip.hinge.joint.max_yaw_rad = held.hands > 1 ? kFree : 0.0;
  const Mover &front = movers_[grip.hinge.front], &behind = movers_[grip.hinge.behind];
  if (held.hands > 1) grip.hinge.behind_end = at;
  const Vector2 place = point_of(behind, grip.hinge.behind_end);
  grip.hinge.front_end = front.ahead().turn_back(minus(place, front.place()));
  grip.turned_rad = wrap_angle(behind.heading_rad() - front.heading_rad());
  const auto next =
      std::lower_bound(grips_.begin(), grips_.end(), grip, [](const Grip& a, const Grip& b) {
        return std::tie(a.box, a.robot) < std::tie(b.box, b.robot);
      });
  require(next == grips_.end() || next->box != box || next->robot != robot,
          "The robot holds the box already.");
  grips_.insert(next, grip);
  ++held.holders;
  take_footing(held);
  are_grips_noted_ = false;
}

void PlanarEngine::let_go(std::size_t robot, std::size_t box) {
  const auto is_it = [&](const Grip& grip) { return grip.box == box && grip.robot == robot; };
  if (std::erase_if(grips_, is_it) == 0) return;
  BoxBody& free = boxes_.at(box);
  --free.holders;
  take_footing(free);
  are_grips_noted_ = false;
}

void PlanarEngine::take_footing(const BoxBody& box) {
  mover_of_box(box).set_footing(box.holders >= box.hands ? Mover::Footing::glides
                                : box.hands > 1          ? Mover::Footing::stands
                                                         : Mover::Footing::slides);
}

/// A robot and what it holds do not meet.
void PlanarEngine::note_grips() {
  if (std::exchange(are_grips_noted_, true)) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Grip& grip : grips_) {
    pairs.emplace_back(std::minmax(robot_bodies_[grip.robot].first_collider,
                                   std::uint32_t{boxes_[grip.box].collider}));
  }
  std::sort(pairs.begin(), pairs.end());
  pipeline_.leave_out(std::move(pairs));
}

void PlanarEngine::begin_grips() {
  note_grips();
  for (Grip& grip : grips_) {
    const Pose wanted = grip.wanted(movers_);
    const Mover& box = movers_[grip.hinge.behind];
    if (boxes_[grip.box].hands == 1) {
      grip.hinge.yaw_rad = wrap_angle(box.heading_rad() - wanted.heading_rad);
    }
    grip.hinge.apart = minus(point_of(box, grip.hinge.behind_end), {wanted.x, wanted.y});
    hinges_.push_back(&grip.hinge);
  }
}

/// Where robots have a box that they hold, which has the heading `now_rad`. The places at which
/// they hold it are only nearly as far from each other as on the box: the best fit, by least
/// squares.
Pose PlanarEngine::carried(std::span<const Grip> grips, double now_rad) const {
  const double share = 1.0 / static_cast<double>(grips.size());
  Vector2 middle, own;  // of the places where it is to be held, and of those on the box
  for (const Grip& grip : grips) {
    const Pose wanted = grip.wanted(movers_);
    middle = plus(middle, {share * wanted.x, share * wanted.y});
    own = plus(own, {share * grip.hinge.behind_end.x, share * grip.hinge.behind_end.y});
    if (boxes_[grip.box].hands == 1) now_rad = wanted.heading_rad;
  }
  double along = 0.0, across = 0.0;
  for (const Grip& grip : grips) {
    const Pose wanted = grip.wanted(movers_);
    const Vector2 to = minus({wanted.x, wanted.y}, middle),
                  from = minus(grip.hinge.behind_end, own);
    along += from.x * to.x + from.y * to.y;
    across += from.x * to.y - from.y * to.x;
  }
  constexpr double kSame = 1e-9;  // m2
  if (std::hypot(along, across) > kSame) now_rad = std::atan2(across, along);
  const Vector2 place = minus(middle, Direction::of(now_rad).turn(own));
  return {place.x, place.y, now_rad};
}

void PlanarEngine::settle_grips(PlanarScene::Moves& moves) {
  for (auto first = grips_.begin(); first != grips_.end();) {
    const BoxBody& box = boxes_[first->box];
    const auto last = first + box.holders;
    if (box.holders >= box.hands) {
      Mover& mover = movers_[first->hinge.behind];
      const Pose pose = carried({first, last}, mover.heading_rad());
      mover.put({pose.x, pose.y}, pose.heading_rad);
      scene_.move(box.collider, mover.place(), mover.ahead(), moves);
    }
    first = last;
  }
}

}  // namespace elsie::physics
