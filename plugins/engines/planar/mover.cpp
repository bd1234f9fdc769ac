#include "mover.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace elsie::physics {
namespace {

// An undercarriage that becomes tighter more often than this in one step goes back and forth
// between states.
constexpr int kMostTighter = 8;

}  // namespace

const Inertia Mover::kNoInertia;

void Mover::put(const Vector2& place, double heading_rad) {
  place_ = place;
  turn_to(heading_rad);
}

void Mover::turn_to(double heading_rad) {
  heading_rad_ = wrap_angle(heading_rad);
  ahead_ = Direction::of(heading_rad_);
}

void Mover::stop() {
  velocity_ = free_ = {};
  if (wheels_) wheels_.roll({});
}

void Mover::push(const Twist& velocity, const Vector2& point, double step) {
  const Vector2 from{center().x - point.x, center().y - point.y};
  velocity_ = ahead_.turn_back(Twist{velocity.x - velocity.turn * from.y,
                                     velocity.y + velocity.turn * from.x, velocity.turn});
  carry(step);
  if (wheels_) wheels_.roll(velocity_);
}

void Mover::take(const Mover& other, double step) {
  place_ = other.place_;
  ahead_ = other.ahead_;
  heading_rad_ = other.heading_rad_;
  velocity_ = other.velocity_;
  carry(step);
  if (wheels_) wheels_.take(other.wheels_);
}

Vector2 Mover::center() const {
  const Vector2 from = ahead_.turn(inertia().center);
  return {place_.x + from.x, place_.y + from.y};
}

Twist Mover::ground(const Twist& free) {
  if (wheels_) return wheels_.solve(free);
  if (footing_ == Footing::stands) return {};
  return footing_ == Footing::glides ? free : sled_->friction.solve(free);
}

/// In the next step, the body turns below its momentum.
void Mover::carry(double step) {
  free_ = velocity_.turn == 0.0
              ? velocity_
              : HalfTurn(0.5 * step * velocity_.turn).whole().turn_back(velocity_);
}

void Mover::begin() {
  impact_ = nullptr;
  if (is_dynamic()) velocity_ = ground(free_);
}

void Mover::enter(double step, Impact& impact) {
  impact_ = &impact;
  impact.middle = ahead_.turned(HalfTurn(0.5 * step * velocity_.turn).half());
  impact.free = impact.moving = impact.middle.turn(velocity_);
  impact.impulse = {};
  impact.shifted = {};
  impact.part = 1.0;
  impact.tighter = 0;
  impact.response = answer();
}

Symmetric Mover::answer() const {
  if (wheels_) return wheels_.response().turned(impact_->middle);
  if (!gives_way()) return {};
  Symmetric free;
  free.xx = free.yy = 1.0 / sled_->inertia.mass;
  free.tt = 1.0 / sled_->inertia.about_center;
  return free;
}

Mover::Stand Mover::stand() {
  if (!is_dynamic()) return {};
  Impact& now = *impact_;
  const Twist before = now.moving;
  const std::uint32_t known = wheels_ ? wheels_.changes() : 0;
  const Direction& middle = now.middle;
  now.moving = middle.turn(ground(inertia().after(free_, middle.turn_back(now.impulse))));
  Stand stood{std::max(std::abs(now.moving.x - before.x), std::abs(now.moving.y - before.y))};
  if (wheels_ && known != wheels_.changes()) {
    const Symmetric next = answer();
    const Symmetric& last = now.response;
    stood.is_looser = next.xx + next.yy + next.tt > last.xx + last.yy + last.tt;
    if (stood.is_looser) {
      now.response = next;
    } else if (++now.tighter > kMostTighter) {
      // At least as loose as either in all directions, and looser each time.
      now.response = last + next;
      stood.is_looser = true;
    }
  }
  return stood;
}

/// Its place after an arc: `turn` is half of the arc's angle, `middle` its direction in the middle.
inline Placement Mover::along(const Twist& velocity, const HalfTurn& turn, const Direction& middle,
                              double step) const {
  const double way = step * turn.sinc;
  const Vector2 moved = middle.turn(Vector2{way * velocity.x, way * velocity.y});
  const Direction next = ahead_.turned(turn.whole()).normal();
  const Vector2 &c = inertia().center, was = ahead_.turn(c), is = next.turn(c);
  return {{place_.x + moved.x + was.x - is.x, place_.y + moved.y + was.y - is.y}, next};
}

Placement Mover::after(double part, double step) const {
  const double time = part * step;
  const Twist velocity = is_dynamic() ? impact_->middle.turn_back(impact_->moving) : velocity_;
  return along(velocity, HalfTurn(0.5 * time * velocity.turn), impact_->middle, time);
}

void Mover::advance(double step) {
  const Impact* const impact = std::exchange(impact_, nullptr);
  if (impact && is_dynamic()) {
    velocity_ = impact->middle.turn_back(impact->moving);
    step *= impact->part;
  }
  if (wheels_) wheels_.settle(velocity_);
  free_ = velocity_;
  if (velocity_ == Twist{}) return;
  const HalfTurn turn(0.5 * step * velocity_.turn);
  const Placement next =
      along(velocity_, turn, impact ? impact->middle : ahead_.turned(turn.half()), step);
  place_ = next.place;
  ahead_ = next.ahead;
  if (velocity_.turn != 0.0) free_ = turn.whole().turn_back(velocity_);  // as carry()
  heading_rad_ += step * velocity_.turn;
  if (std::abs(heading_rad_) > std::numbers::pi) heading_rad_ = wrap_angle(heading_rad_);
}

}  // namespace elsie::physics
