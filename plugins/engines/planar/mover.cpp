#include "mover.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace elsie::physics {

void Mover::put(const Vector2& place, double heading_rad) {
  place_ = place;
  turn_to(heading_rad);
}

void Mover::turn_to(double heading_rad) {
  heading_rad_ = wrap_angle(heading_rad);
  ahead_ = Direction::of(heading_rad_);
}

void Mover::stop() {
  velocity_ = {};
  if (wheels_) wheels_->roll({});
}

void Mover::push(const Twist& velocity, const Vector2& point) {
  const Vector2 from{center().x - point.x, center().y - point.y};
  velocity_ = ahead_.turn_back(Twist{velocity.x - velocity.turn * from.y,
                                     velocity.y + velocity.turn * from.x, velocity.turn});
  if (wheels_) wheels_->roll(velocity_);
}

void Mover::take(const Mover& other) {
  place_ = other.place_;
  ahead_ = other.ahead_;
  heading_rad_ = other.heading_rad_;
  velocity_ = other.velocity_;
  if (wheels_) wheels_->take(*other.wheels_);
}

Vector2 Mover::center() const {
  const Vector2 from = ahead_.turn(inertia_.center);
  return {place_.x + from.x, place_.y + from.y};
}

Twist Mover::ground(const Twist& free) {
  return wheels_ ? wheels_->solve(free) : friction_.solve(free);
}

void Mover::begin(double step) {
  entered_ = false;
  if (!gives_way_) return;
  // The body turns below its momentum.
  free_ = velocity_.turn == 0.0
              ? velocity_
              : HalfTurn(0.5 * step * velocity_.turn).whole().turn_back(velocity_);
  velocity_ = ground(free_);
}

void Mover::enter(double step) {
  entered_ = true;
  middle_ = ahead_.turned(HalfTurn(0.5 * step * velocity_.turn).half());
  moving_ = middle_.turn(velocity_);
  impulse_ = {};
  shifted_ = {};
  response_ = answer();
}

Symmetric Mover::answer() const {
  if (wheels_) return wheels_->response().turned(middle_);
  if (!gives_way_) return {};
  Symmetric free;
  free.xx = free.yy = 1.0 / inertia_.mass;
  free.tt = 1.0 / inertia_.about_center;
  return free;
}

Mover::Stand Mover::stand() {
  if (!gives_way_) return {};
  const Twist before = moving_;
  const std::uint32_t known = wheels_ ? wheels_->changes() : 0;
  moving_ = middle_.turn(ground(inertia_.after(free_, middle_.turn_back(impulse_))));
  Stand stood{std::max(std::abs(moving_.x - before.x), std::abs(moving_.y - before.y))};
  if (wheels_ && known != wheels_->changes()) {
    const Symmetric next = answer();
    stood.is_looser = next.xx + next.yy + next.tt > response_.xx + response_.yy + response_.tt;
    if (stood.is_looser) response_ = next;
  }
  return stood;
}

void Mover::advance(double step) {
  if (entered_ && gives_way_) velocity_ = middle_.turn_back(moving_);
  if (wheels_) wheels_->settle(velocity_);
  if (velocity_ == Twist{}) return;
  const HalfTurn turn(0.5 * step * velocity_.turn);
  if (!entered_) middle_ = ahead_.turned(turn.half());
  const double way = step * turn.sinc;
  const Vector2 moved = middle_.turn(Vector2{way * velocity_.x, way * velocity_.y});
  const Direction next = ahead_.turned(turn.whole()).normal();
  const Vector2 &c = inertia_.center, was = ahead_.turn(c), is = next.turn(c);
  place_ = {place_.x + moved.x + was.x - is.x, place_.y + moved.y + was.y - is.y};
  ahead_ = next;
  heading_rad_ += step * velocity_.turn;
  if (std::abs(heading_rad_) > std::numbers::pi) heading_rad_ = wrap_angle(heading_rad_);
}

}  // namespace elsie::physics
