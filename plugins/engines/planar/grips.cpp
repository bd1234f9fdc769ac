// Robots that hold boxes. A box that is held is joined to its robot by a hinge, and glides on the
// floor. The hinge does not turn, unless the box takes several hands.
#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "checks.h"
#include "planar_engine.h"

namespace elsie::physics {
namespace {

constexpr double kFree = 1e9;  // rad

}  // namespace

Pose PlanarEngine::Grip::wanted(std::span<const Mover> movers) const {
  const Mover& own = movers[hinge.front];
  const Vector2 arm = own.ahead().turn(hinge.front_end);
  return {own.place().x + arm.x, own.place().y + arm.y, own.heading_rad() + turned_rad};
}

void PlanarEngine::hold(std::size_t robot, std::size_t box) {
  BoxBody& held = boxes_.at(box);
  check_hold(held.kind, held.present, held.holders, held.hands);
  Grip grip{box, robot, {}};
  grip.hinge.front = robots_.at(robot).first();
  grip.hinge.behind = colliders_[held.collider].mover;
  grip.hinge.joint.max_yaw_rad = held.hands > 1 ? kFree : 0.0;
  const Mover &front = movers_[grip.hinge.front], &behind = movers_[grip.hinge.behind];
  grip.hinge.front_end = front.ahead().turn_back(
      Vector2{behind.place().x - front.place().x, behind.place().y - front.place().y});
  grip.turned_rad = wrap_angle(behind.heading_rad() - front.heading_rad());
  const auto place =
      std::lower_bound(grips_.begin(), grips_.end(), grip, [](const Grip& a, const Grip& b) {
        return std::tie(a.box, a.robot) < std::tie(b.box, b.robot);
      });
  require(place == grips_.end() || place->box != box || place->robot != robot,
          "The robot holds the box already.");
  grips_.insert(place, grip);
  ++held.holders;
  take_footing(held);
  note_grips();
}

void PlanarEngine::let_go(std::size_t robot, std::size_t box) {
  const auto is_it = [&](const Grip& grip) { return grip.box == box && grip.robot == robot; };
  if (std::erase_if(grips_, is_it) == 0) return;
  BoxBody& free = boxes_.at(box);
  --free.holders;
  take_footing(free);
  note_grips();
}

void PlanarEngine::take_footing(const BoxBody& box) {
  mover_of_box(box).set_footing(box.holders >= box.hands ? Mover::Footing::glides
                                : box.hands > 1          ? Mover::Footing::stands
                                                         : Mover::Footing::slides);
}

/// A robot and what it holds do not meet.
void PlanarEngine::note_grips() {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const Grip& grip : grips_) {
    pairs.emplace_back(std::minmax(robot_bodies_[grip.robot].first_collider,
                                   std::uint32_t{boxes_[grip.box].collider}));
  }
  std::sort(pairs.begin(), pairs.end());
  pipeline_.leave_out(std::move(pairs));
}

void PlanarEngine::begin_grips() {
  for (Grip& grip : grips_) {
    const Pose wanted = grip.wanted(movers_);
    const Mover& box = movers_[grip.hinge.behind];
    if (boxes_[grip.box].hands == 1) {
      grip.hinge.yaw_rad = wrap_angle(box.heading_rad() - wanted.heading_rad);
    }
    grip.hinge.apart = {box.place().x - wanted.x, box.place().y - wanted.y};
    hinges_.push_back(&grip.hinge);
  }
}

/// Puts each box that is carried where its robot has it: in the middle if there are several.
void PlanarEngine::settle_grips(PlanarScene::Moves& moves) {
  for (auto first = grips_.begin(); first != grips_.end();) {
    const BoxBody& box = boxes_[first->box];
    const auto last = first + box.holders;
    if (box.holders >= box.hands) {
      Pose sum;
      for (auto grip = first; grip != last; ++grip) {
        const Pose wanted = grip->wanted(movers_);
        sum.x += wanted.x / box.holders;
        sum.y += wanted.y / box.holders;
        sum.heading_rad = wanted.heading_rad;
      }
      Mover& mover = movers_[first->hinge.behind];
      mover.put({sum.x, sum.y}, box.hands > 1 ? mover.heading_rad() : sum.heading_rad);
      scene_.move(box.collider, mover.place(), mover.ahead(), moves);
    }
    first = last;
  }
}

}  // namespace elsie::physics
