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

// After this many changes of mind, grips only become looser.
constexpr int kSearches = 6;
constexpr int kMostSearches = 12;

}  // namespace

Undercarriage::Undercarriage(std::span<const Part> parts, const std::vector<double>& loads,
                             const Inertia& inertia, const world::Physics& physics)
    : inertia_(inertia),
      step_(physics.step),
      slip_(std::max(physics.wheel_slip, kLeastSlip)),
      stiffness_(1.0 / slip_),
      friction_(kTyreGrip * physics.friction) {
  std::size_t wheels = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Part& part = parts[i];
    const auto* wheel = std::get_if<WheelJoint>(&part.joint);
    if (!wheel) continue;
    const Vector3& at = part.frame.origin;
    const double radius = part.shape.radius();
    const double heading = std::atan2(part.frame.forward.y, part.frame.forward.x);
    const auto add = [&](double angle) {
      Grip& grip = grips_.emplace_back();
      grip.limit = friction_ * loads[i];
      if (wheel->torque > 0.0 && std::abs(std::cos(angle)) > kLeastCosine) {
        grip.rim = radius * std::cos(angle);
        grip.torque = wheel->torque;
        grip.per_torque = step_ / std::max(0.5 * part.mass * radius * radius, kLeastInertia);
      }
      grip.stiffness = 1.0 / (slip_ + grip.rim * grip.rim * grip.per_torque);
      mounts_.push_back({{at.x - inertia.center.x, at.y - inertia.center.y}, angle, wheels});
      aim(grips_.size() - 1, heading);
    };
    if (wheel->rollers_rad) {
      add(*wheel->rollers_rad);
    } else {
      if (wheel->torque > 0.0) add(0.0);
      add(0.5 * std::numbers::pi);
    }
    ++wheels;
  }
}

std::size_t Undercarriage::motor_of(std::size_t wheel) const {
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    if (mounts_[i].wheel == wheel && grips_[i].is_driven()) return i;
  }
  return kNoMotor;
}

void Undercarriage::aim(std::size_t grip, double heading_rad) {
  const Mount& mount = mounts_[grip];
  const Direction along = Direction::of(heading_rad + mount.angle);
  grips_[grip].along = {along.c, along.s, mount.place.x * along.s - mount.place.y * along.c};
  is_known_ = is_rolling_known_ = false;
}

void Undercarriage::point(std::size_t wheel, double heading_rad) {
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    if (mounts_[i].wheel == wheel) aim(i, heading_rad);
  }
}

void Undercarriage::roll(const Twist& velocity) {
  for (Grip& grip : grips_) {
    if (grip.is_driven()) grip.rate = dot(grip.along, velocity) / grip.rim;
    grip.hold = Hold::rolls;
  }
  loose_ = 0;
  is_known_ = false;
}

void Undercarriage::take(const Undercarriage& other) {
  for (std::size_t i = 0; i < grips_.size(); ++i) {
    Grip& grip = grips_[i];
    const Grip& same = other.grips_[i];
    grip.along = same.along;
    grip.rate = same.rate;
    grip.wanted = same.wanted;
    grip.hold = same.hold;
  }
  loose_ = other.loose_;
  is_known_ = is_rolling_known_ = false;
}

Undercarriage::Law Undercarriage::law(const Grip& grip) const {
  if (grip.hold == Hold::rolls) return {stiffness_, grip.rim * grip.wanted};
  // The motor gives its most, and the wheel turns as tyre and motor make it.
  const double torque = grip.hold == Hold::motor_up ? grip.torque : -grip.torque;
  return {grip.stiffness, grip.rim * (grip.rate + grip.per_torque * torque)};
}

double Undercarriage::force(const Grip& grip, double moving) const {
  if (grip.hold == Hold::slides_up) return grip.limit;
  if (grip.hold == Hold::slides_down) return -grip.limit;
  const Law known = law(grip);
  return known.stiffness * (known.speed - moving);
}

/// The rate of a wheel after a step in which its tyre pulls with this force.
double Undercarriage::turning(const Grip& grip, double pull) {
  const double rolling = grip.rate - grip.per_torque * grip.rim * pull;
  const double most = grip.per_torque * grip.torque;
  return std::clamp(grip.wanted, rolling - most, rolling + most);
}

/// The state of the grip at this velocity.
Undercarriage::Hold Undercarriage::fitting(const Grip& grip, const Twist& velocity) const {
  const double moving = dot(grip.along, velocity), pull = force(grip, moving);
  if (grip.hold >= Hold::slides_up) {
    // The rim is still faster than the floor below it, in the direction of the force.
    double rate = 0.0;
    Hold otherwise = Hold::rolls;
    if (grip.is_driven()) {
      rate = turning(grip, pull);
      otherwise = rate < grip.wanted   ? Hold::motor_up
                  : rate > grip.wanted ? Hold::motor_down
                                       : Hold::rolls;
    }
    const double gliding = grip.rim * rate - moving;
    const double least = slip_ * grip.limit;
    const bool still = grip.hold == Hold::slides_up ? gliding >= least : gliding <= -least;
    return still ? grip.hold : otherwise;
  }
  // Most motors are at their limit before their tyres are.
  if (grip.is_driven() && grip.hold == Hold::rolls) {
    const double torque = (grip.wanted - grip.rate) / grip.per_torque + grip.rim * pull;
    if (std::abs(torque) > grip.torque) return torque > 0.0 ? Hold::motor_up : Hold::motor_down;
  }
  if (std::abs(pull) > grip.limit) return pull > 0.0 ? Hold::slides_up : Hold::slides_down;
  if (grip.hold == Hold::rolls) return Hold::rolls;
  const double torque = grip.hold == Hold::motor_up ? grip.torque : -grip.torque;
  const double rate = grip.rate + grip.per_torque * (torque - grip.rim * pull);
  const bool is_short = grip.hold == Hold::motor_up ? rate <= grip.wanted : rate >= grip.wanted;
  return is_short ? grip.hold : Hold::rolls;
}

void Undercarriage::respond() {
  is_known_ = true;
  ++changes_;
  const bool rolls = std::all_of(grips_.begin(), grips_.end(),
                                 [](const Grip& grip) { return grip.hold == Hold::rolls; });
  if (rolls && is_rolling_known_) {
    response_ = rolling_;
    return;
  }
  Symmetric inertia;
  inertia.xx = inertia.yy = inertia_.mass;
  inertia.tt = inertia_.about_center;
  for (const Grip& grip : grips_) {
    if (grip.hold < Hold::slides_up) inertia.add(step_ * law(grip).stiffness, grip.along);
  }
  response_ = inertia.inverse();
  if (!rolls) return;
  rolling_ = response_;
  is_rolling_known_ = true;
}

Twist Undercarriage::solve(const Twist& free) {
  const Twist momentum{inertia_.mass * free.x, inertia_.mass * free.y,
                       inertia_.about_center * free.turn};
  if (loose_ == 0) {
    if (!is_known_) respond();
    const Twist velocity = rolling(momentum);
    if (all_roll(velocity)) return velocity;
  }
  return search(momentum);
}

/// The velocity if nothing is at a limit.
Twist Undercarriage::rolling(Twist momentum) const {
  for (const Grip& grip : grips_) {
    if (!grip.is_driven()) continue;
    const double push = step_ * stiffness_ * (grip.rim * grip.wanted);
    momentum = momentum + push * grip.along;
  }
  return response_ * momentum;
}

bool Undercarriage::all_roll(const Twist& velocity) const {
  for (const Grip& grip : grips_) {
    const double moving = dot(grip.along, velocity);
    if (!grip.is_driven()) {
      if (stiffness_ * std::abs(moving) > grip.limit) return false;
      continue;
    }
    const double pull = stiffness_ * (grip.rim * grip.wanted - moving);
    const double gained = grip.wanted - grip.rate + grip.per_torque * grip.rim * pull;
    if (std::abs(pull) > grip.limit || std::abs(gained) > grip.per_torque * grip.torque) {
      return false;
    }
  }
  return true;
}

/// The velocity, and the limits that fit to it.
Twist Undercarriage::search(const Twist& momentum) {
  Twist velocity;
  for (int search = 1; search <= kMostSearches; ++search) {
    if (!is_known_) respond();
    Twist pushed = momentum;
    for (const Grip& grip : grips_) {
      double push = 0.0;
      if (grip.hold < Hold::slides_up) {
        if (!grip.is_driven()) continue;
        const Law known = law(grip);
        push = known.stiffness * known.speed;
      } else {
        push = grip.hold == Hold::slides_up ? grip.limit : -grip.limit;
      }
      pushed = pushed + step_ * push * grip.along;
    }
    velocity = response_ * pushed;
    if (search == kMostSearches) break;
    bool fits = true;
    for (Grip& grip : grips_) {
      Hold next = fitting(grip, velocity);
      if (search > kSearches && next < grip.hold) next = grip.hold;
      if (next == grip.hold) continue;
      grip.hold = next;
      fits = is_known_ = false;
    }
    if (fits) break;
  }
  loose_ = static_cast<int>(std::count_if(
      grips_.begin(), grips_.end(), [](const Grip& grip) { return grip.hold != Hold::rolls; }));
  return velocity;
}

void Undercarriage::settle(const Twist& velocity) {
  for (Grip& grip : grips_) {
    if (!grip.is_driven()) continue;
    if (grip.hold == Hold::rolls) {
      grip.rate = grip.wanted;
    } else {
      const double pull = force(grip, dot(grip.along, velocity));
      grip.rate = turning(grip, std::clamp(pull, -grip.limit, grip.limit));
    }
  }
}

FloorFriction::FloorFriction(const Inertia& inertia, double lever, const world::Physics& physics)
    : inertia_(inertia),
      force_(physics.step * physics.friction * inertia.mass * std::abs(physics.gravity)),
      torque_(lever * force_) {}

Twist FloorFriction::solve(const Twist& free) const {
  const double speed = std::hypot(free.x, free.y);
  if (speed == 0.0 && free.turn == 0.0) return free;
  const double by_force = inertia_.mass * speed / force_;
  const double by_torque = inertia_.about_center * std::abs(free.turn) / torque_;
  if (by_force * by_force + by_torque * by_torque <= 1.0) return {};
  // The impulse on the ellipsoid that takes the most energy.
  const double x = force_ * speed, t = torque_ * free.turn;
  const double scale = std::hypot(x, t);
  if (!(scale > 0.0)) return free;
  const double braked = force_ * x / scale / inertia_.mass;
  const double turned = torque_ * std::abs(t) / scale / inertia_.about_center;
  const double factor = speed > braked ? 1.0 - braked / speed : 0.0;
  const double turn = std::max(0.0, std::abs(free.turn) - turned);
  return {factor * free.x, factor * free.y, std::copysign(turn, free.turn)};
}

}  // namespace elsie::physics
