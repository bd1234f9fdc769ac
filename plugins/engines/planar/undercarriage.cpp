#include "undercarriage.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace elsie::physics {
namespace {

// Rubber tyres have more grip than chassis and boxes, as in the other engine.
constexpr double kTyreGrip = 3.0;

// Grips that do not glide at all would leave no digits for the masses.
constexpr double kLeastSlip = 1e-7;  // m/s per N

// Rollers that lie along the axle leave nothing to drive.
constexpr double kLeastCosine = 1e-9;

constexpr double kLeastInertia = 1e-300;  // kg m2

// After this many changes of state, grips only become looser.
constexpr int kSearches = 6;
constexpr int kMostSearches = 12;

}  // namespace

Undercarriage::Undercarriage(std::span<const Part> parts, const std::vector<double>& loads,
                             const Inertia& inertia, const world::Physics& physics)
    : model_(std::make_shared<Model>()) {
  Model& made = *model_;
  made.inertia = inertia;
  made.step = physics.step;
  made.slip = std::max(physics.wheel_slip, kLeastSlip);
  made.stiffness = 1.0 / made.slip;
  made.firmness = made.step * made.stiffness;
  made.friction = kTyreGrip * physics.friction;
  std::size_t wheels = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    if (!wheel) continue;
    const Vector3& at = part.frame.origin;
    const double radius = part.shape.radius();
    const double heading = std::atan2(part.frame.forward.y, part.frame.forward.x);
    const auto add = [&](double angle) {
      Grip& grip = made.grips.emplace_back();
      grip.limit = made.friction * loads[i];
      if (wheel->torque > 0.0 && std::abs(std::cos(angle)) > kLeastCosine) {
        grip.rim = radius * std::cos(angle);
        grip.torque = wheel->torque;
        grip.per_torque = made.step / std::max(0.5 * part.mass * radius * radius, kLeastInertia);
        grip.per_force = grip.per_torque * grip.rim;
        grip.most = grip.per_torque * grip.torque;
      }
      grip.stiffness = 1.0 / (made.slip + grip.rim * grip.rim * grip.per_torque);
      made.mounts.push_back({{at.x - inertia.center.x, at.y - inertia.center.y}, angle, wheels});
      made.aim(made.grips.size() - 1, heading);
    };
    if (wheel->rollers_rad) {
      add(*wheel->rollers_rad);
    } else {
      if (wheel->torque > 0.0) add(0.0);
      add(0.5 * std::numbers::pi);
    }
    ++wheels;
  }
  made.find_rolling();
  made.count = made.grips.size();
  turnings_ = std::make_unique<Turning[]>(made.count);
}

Undercarriage::Undercarriage(const Undercarriage& other)
    : model_(other.model_),
      turnings_(model_ ? std::make_unique<Turning[]>(model_->count) : nullptr),
      changes_(other.changes_),
      is_loose_(other.is_loose_),
      is_known_(other.is_known_),
      response_(other.response_) {
  if (model_) std::copy_n(other.turnings_.get(), model_->count, turnings_.get());
}

std::size_t Undercarriage::motor_of(std::size_t wheel) const {
  for (std::size_t i = 0; i < model_->count; ++i) {
    if (model_->mounts[i].wheel == wheel && model_->grips[i].is_driven()) return i;
  }
  return kNoMotor;
}

void Undercarriage::Model::aim(std::size_t grip, double heading_rad) {
  const Mount& mount = mounts[grip];
  const Direction along = Direction::of(heading_rad + mount.angle);
  grips[grip].along = {along.c, along.s, mount.place.x * along.s - mount.place.y * along.c};
}

void Undercarriage::Model::find_rolling() {
  Symmetric sum;
  sum.xx = sum.yy = inertia.mass;
  sum.tt = inertia.about_center;
  for (const Grip& grip : grips) sum.add(step * stiffness, grip.along);
  rolling = sum.inverse();
}

void Undercarriage::point(std::size_t wheel, double heading_rad) {
  own_model();
  for (std::size_t i = 0; i < model_->count; ++i) {
    if (model_->mounts[i].wheel == wheel) model_->aim(i, heading_rad);
  }
  model_->find_rolling();
  is_known_ = false;
}

void Undercarriage::roll(const Twist& velocity) {
  for (std::size_t i = 0; i < model_->count; ++i) {
    const Grip& grip = model_->grips[i];
    if (grip.is_driven()) turnings_[i].rate = dot(grip.along, velocity) / grip.rim;
    turnings_[i].hold = Hold::rolls;
  }
  is_loose_ = false;
  is_known_ = false;
}

void Undercarriage::take(const Undercarriage& other) {
  bool is_aimed = true;
  for (std::size_t i = 0; i < model_->count; ++i) {
    is_aimed = is_aimed && model_->grips[i].along == other.model_->grips[i].along;
  }
  if (!is_aimed) {
    own_model();
    for (std::size_t i = 0; i < model_->count; ++i) {
      model_->grips[i].along = other.model_->grips[i].along;
    }
    model_->find_rolling();
  }
  std::copy_n(other.turnings_.get(), model_->count, turnings_.get());
  is_loose_ = other.is_loose_;
  is_known_ = false;
}

/// Of a motor that holds its rate, s = wanted, so that F = (g wanted - J V) / slip. With the motor
/// at its limit T, the motor's equation for s in the tyre's equation gives
///
///   F = (g (s0 + h T / I) - J V) / (slip + g^2 h / I).
inline Undercarriage::Law Undercarriage::law(const Grip& grip, const Turning& now) const {
  if (now.hold == Hold::rolls) return {model_->stiffness, grip.rim * now.wanted};
  const double torque = now.hold == Hold::motor_up ? grip.torque : -grip.torque;
  return {grip.stiffness, grip.rim * (now.rate + grip.per_torque * torque)};
}

inline double Undercarriage::force(const Grip& grip, const Turning& now, double moving) const {
  if (now.hold == Hold::slides_up) return grip.limit;
  if (now.hold == Hold::slides_down) return -grip.limit;
  const Law known = law(grip, now);
  return known.stiffness * (known.speed - moving);
}

/// The rate of a wheel after a step in which its tyre pulls with this force.
inline double Undercarriage::turning(const Grip& grip, const Turning& now, double pull) {
  const double rolling = now.rate - grip.per_force * pull;
  return std::clamp(now.wanted, rolling - grip.most, rolling + grip.most);
}

/// The state of the grip at this velocity.
inline Undercarriage::Hold Undercarriage::fitting(const Grip& grip, const Turning& now,
                                                  const Twist& velocity) const {
  const double moving = dot(grip.along, velocity), pull = force(grip, now, moving);
  if (now.hold >= Hold::slides_up) {
    // The rim is still faster than the floor below it, in the direction of the force.
    double rate = 0.0;
    Hold otherwise = Hold::rolls;
    if (grip.is_driven()) {
      rate = turning(grip, now, pull);
      otherwise = rate < now.wanted   ? Hold::motor_up
                  : rate > now.wanted ? Hold::motor_down
                                      : Hold::rolls;
    }
    const double gliding = grip.rim * rate - moving;
    const double least = model_->slip * grip.limit;
    const bool still = now.hold == Hold::slides_up ? gliding >= least : gliding <= -least;
    return still ? now.hold : otherwise;
  }
  // Most motors are at their limit before their tyres are.
  if (grip.is_driven() && now.hold == Hold::rolls) {
    const double torque = (now.wanted - now.rate) / grip.per_torque + grip.rim * pull;
    if (std::abs(torque) > grip.torque) return torque > 0.0 ? Hold::motor_up : Hold::motor_down;
  }
  if (std::abs(pull) > grip.limit) return pull > 0.0 ? Hold::slides_up : Hold::slides_down;
  if (now.hold == Hold::rolls) return Hold::rolls;
  const double torque = now.hold == Hold::motor_up ? grip.torque : -grip.torque;
  const double rate = now.rate + grip.per_torque * (torque - grip.rim * pull);
  const bool is_short = now.hold == Hold::motor_up ? rate <= now.wanted : rate >= now.wanted;
  return is_short ? now.hold : Hold::rolls;
}

/// With the forces of law() in the body's equation,
///
///   (M + h sum of k J' J) V = M V0 + h sum of J' k speed + h sum of J' (+- limit),
///
/// where the last sum is over the grips that slide. The inverse of the matrix on the left is the
/// response to an impulse, too.
void Undercarriage::respond() {
  is_known_ = true;
  ++changes_;
  response_ = model_->rolling;
  const auto all = turnings();
  if (std::all_of(all.begin(), all.end(),
                  [](const Turning& now) { return now.hold == Hold::rolls; })) {
    return;
  }
  Symmetric inertia;
  inertia.xx = inertia.yy = model_->inertia.mass;
  inertia.tt = model_->inertia.about_center;
  for (std::size_t i = 0; i < model_->count; ++i) {
    const Grip& grip = model_->grips[i];
    if (turnings_[i].hold < Hold::slides_up) {
      inertia.add(model_->step * law(grip, turnings_[i]).stiffness, grip.along);
    }
  }
  response_ = inertia.inverse();
}

/// The velocity if nothing is at a limit.
inline Twist Undercarriage::rolling(Twist momentum) const {
  const Model& model = *model_;
  for (std::size_t i = 0; i < model_->count; ++i) {
    const Grip& grip = model.grips[i];
    if (!grip.is_driven()) continue;
    const double push = model.firmness * (grip.rim * turnings_[i].wanted);
    momentum = momentum + push * grip.along;
  }
  return model.rolling * momentum;
}

inline bool Undercarriage::all_roll(const Twist& velocity) const {
  const Model& model = *model_;
  for (std::size_t i = 0; i < model_->count; ++i) {
    const Grip& grip = model.grips[i];
    const double moving = dot(grip.along, velocity);
    if (!grip.is_driven()) {
      if (model.stiffness * std::abs(moving) > grip.limit) return false;
      continue;
    }
    const auto& [rate, wanted, hold] = turnings_[i];
    const double pull = model.stiffness * (grip.rim * wanted - moving);
    const double gained = wanted - rate + grip.per_force * pull;
    if (std::abs(pull) > grip.limit || std::abs(gained) > grip.most) return false;
  }
  return true;
}

Twist Undercarriage::solve(const Twist& free) {
  const Inertia& inertia = model_->inertia;
  const Twist momentum{inertia.mass * free.x, inertia.mass * free.y,
                       inertia.about_center * free.turn};
  if (!is_loose_) {
    if (!is_known_) respond();
    const Twist velocity = rolling(momentum);
    if (all_roll(velocity)) return velocity;
  }
  return search(momentum);
}

/// The velocity, and the limits that fit to it: those of the last velocity are tried until none
/// changes.
Twist Undercarriage::search(const Twist& momentum) {
  Twist velocity;
  for (int search = 1; search <= kMostSearches; ++search) {
    if (!is_known_) respond();
    Twist pushed = momentum;
    for (std::size_t i = 0; i < model_->count; ++i) {
      const Grip& grip = model_->grips[i];
      const Hold hold = turnings_[i].hold;
      double push = 0.0;
      if (hold < Hold::slides_up) {
        if (!grip.is_driven()) continue;
        const Law known = law(grip, turnings_[i]);
        push = known.stiffness * known.speed;
      } else {
        push = hold == Hold::slides_up ? grip.limit : -grip.limit;
      }
      pushed = pushed + model_->step * push * grip.along;
    }
    velocity = response_ * pushed;
    if (search == kMostSearches) break;
    bool fits = true;
    for (std::size_t i = 0; i < model_->count; ++i) {
      Turning& now = turnings_[i];
      Hold next = fitting(model_->grips[i], now, velocity);
      if (search > kSearches && next < now.hold) next = now.hold;
      if (next == now.hold) continue;
      now.hold = next;
      fits = is_known_ = false;
    }
    if (fits) break;
  }
  const auto all = turnings();
  is_loose_ = std::any_of(all.begin(), all.end(),
                          [](const Turning& now) { return now.hold != Hold::rolls; });
  return velocity;
}

void Undercarriage::settle(const Twist& velocity) {
  if (!is_loose_) {
    for (Turning& now : turnings()) now.rate = now.wanted;
    return;
  }
  for (std::size_t i = 0; i < model_->count; ++i) {
    const Grip& grip = model_->grips[i];
    Turning& now = turnings_[i];
    if (!grip.is_driven()) continue;
    if (now.hold == Hold::rolls) {
      now.rate = now.wanted;
    } else {
      const double pull = force(grip, now, dot(grip.along, velocity));
      now.rate = turning(grip, now, std::clamp(pull, -grip.limit, grip.limit));
    }
  }
}

}  // namespace elsie::physics
