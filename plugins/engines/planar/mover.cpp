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
  free_ = velocity_.turn == 0.0 ? velocity_
                                : HalfTurn(0.5 * step * velocity_.turn).whole().turn_back(velocity_);
  velocity_ = ground(free_);
}

void Mover::enter(double step) {
  entered_ = true;
  middle_ = ahead_.turned(HalfTurn(0.5 * step * velocity_.turn).half());
  moving_ = middle_.turn(velocity_);
  impulse_ = {};
  shifted_ = {};
  respond();
}

void Mover::respond() {
  known_ = changes();
  if (wheels_) {
    response_ = wheels_->response().turned(middle_);
  } else if (gives_way_) {
    response_ = {};
    response_.xx = response_.yy = 1.0 / inertia_.mass;
    response_.tt = 1.0 / inertia_.about_center;
  }
}

double Mover::stand() {
  if (!gives_way_) return 0.0;
  const Twist before = moving_;
  moving_ = middle_.turn(ground(inertia_.after(free_, middle_.turn_back(impulse_))));
  if (known_ != changes()) respond();
  return std::max(std::abs(moving_.x - before.x), std::abs(moving_.y - before.y));
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
