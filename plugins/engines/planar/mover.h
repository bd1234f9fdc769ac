// A rigid body that moves in the plane.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "elsie/api/geometry.h"

#include "plane.h"
#include "undercarriage.h"

namespace elsie::physics {

/// The motion of a body that meets others in a step, in the world.
struct Impact {
  Twist free;          // its velocity if it met nothing
  Twist moving;        // its velocity
  Twist impulse;       // the sum of all impulses
  Direction middle;    // of the body, in the middle of the arc
  Symmetric response;  // the change of velocity that an impulse makes
  Vector2 shifted;     // m, the sum of all shifts
  double part = 1.0;   // of the step's way that it moves
  int tighter = 0;     // how often the undercarriage has become tighter
};

/// A vehicle, a box that can be pushed, or a box that moves along its own path.
///
/// During a step its velocity, seen from the body, does not change: it moves along an arc, and the
/// arc is exact. Between steps the momentum keeps its direction in the world, so the wheels must
/// turn it. Forces act in the middle of the arc.
class alignas(64) Mover {
 public:
  /// A vehicle.
  explicit Mover(Undercarriage wheels) : wheels_(std::move(wheels)) {}
  /// A body that slides.
  Mover(const Inertia& inertia, const FloorFriction& friction)
      : sled_(std::make_shared<Sled>(Sled{inertia, friction})) {}
  /// A box that nothing stops.
  Mover() = default;

  /// Sets the distance of its farthest point from its place, m.
  void set_reach(double reach) { reach_ = reach; }
  void put(const Vector2& place, double heading_rad);
  void stop();
  /// Moves as a rigid body with this velocity (in the world) of a point in the world. `step` is the
  /// length of later steps, s.
  void push(const Twist& velocity, const Vector2& point, double step);
  /// Sets the velocity in the world; only for a box that nothing stops.
  void drive(const Vector2& velocity) {
    velocity_ = ahead_.turn_back(Twist{velocity.x, velocity.y});
  }
  void take(const Mover& other, double step);

  // One step: begin(), then, if it meets something, enter() and any number of impulses and calls of
  // stand(), then advance().

  /// The velocity if it meets nothing.
  void begin();
  /// Prepares for impulses. The impact must last until advance() or release().
  void enter(double step, Impact& impact);
  /// An impulse in the world, and the change of the velocity that it makes at once.
  void add(const Twist& impulse, const Twist& change) {
    impact_->impulse = impact_->impulse + impulse;
    impact_->moving = impact_->moving + change;
  }
  /// Scales the sum of the impulses so far; stand() finds the velocity to it.
  void scale(double factor) { impact_->impulse = factor * impact_->impulse; }
  /// The result of stand().
  struct Stand {
    double changed = 0.0;    // m/s, the largest change of the velocity
    bool is_looser = false;  // the response has changed
  };
  /// Lets the undercarriage hold against the impulses so far.
  Stand stand();
  /// After enter(): where it will be after a part of the step, in [0, 1].
  Placement after(double part, double step) const;
  /// After enter(): lets it move only this part of its way.
  void stop_after(double part) { impact_->part = part; }
  void advance(double step);

  const Inertia& inertia() const {
    return wheels_ ? wheels_.inertia() : sled_ ? sled_->inertia : kNoInertia;
  }
  double reach() const { return reach_; }
  bool is_dynamic() const { return wheels_ || sled_; }
  bool gives_way() const { return is_dynamic() && footing_ != Footing::stands; }
  Undercarriage& wheels() { return wheels_; }
  const Undercarriage& wheels() const { return wheels_; }
  const Vector2& place() const { return place_; }
  const Direction& ahead() const { return ahead_; }
  double heading_rad() const { return heading_rad_; }
  /// The velocity of its center of mass, in its own frame.
  const Twist& velocity() const { return velocity_; }
  /// The velocity of its origin, in its own frame.
  Twist velocity_of_origin() const {
    const Twist& v = velocity_;
    const Vector2& center = inertia().center;
    return {v.x + v.turn * center.y, v.y - v.turn * center.x, v.turn};
  }
  Vector2 center() const;

  // In a step, after enter(), in the world:
  const Twist& moving() const { return impact_->moving; }
  /// Its velocity if it met nothing.
  const Twist& moving_freely() const { return impact_->free; }
  /// Its direction in the middle of the arc.
  const Direction& middle() const { return impact_->middle; }
  /// The change of velocity that an impulse makes. In a step it only grows: if it were smaller than
  /// what the undercarriage lets through, impulses would overshoot for ever.
  const Symmetric& response() const { return impact_->response; }
  /// The sum of all shifts since enter().
  const Vector2& shifted() const { return impact_->shifted; }

  /// Continues as if it had met nothing. A box that nothing stops does so anyway, and others may
  /// still meet it.
  void release() {
    if (is_dynamic()) impact_ = nullptr;
  }

  /// Moves it without changing its velocity.
  void shift(const Vector2& by) {
    place_ = {place_.x + by.x, place_.y + by.y};
    if (impact_) impact_->shifted = {impact_->shifted.x + by.x, impact_->shifted.y + by.y};
  }
  void turn_to(double heading_rad);

  /// How a box that can be pushed is on the floor.
  enum class Footing : std::uint8_t {
    slides,  // with friction
    glides,  // without
    stands   // nothing moves it
  };
  /// Between steps.
  void set_footing(Footing footing) {
    footing_ = footing;
    if (footing == Footing::stands) stop();
  }

 private:
  /// What sliding bodies of one kind share.
  struct Sled {
    Inertia inertia;
    FloorFriction friction;
  };
  static const Inertia kNoInertia;

  Twist ground(const Twist& free);
  Symmetric answer() const;
  void carry(double step);
  Placement along(const Twist& velocity, const HalfTurn& turn, const Direction& middle,
                  double step) const;

  // In the order of use: one step touches few lines of the processor's cache.
  Vector2 place_;  // of its origin
  Direction ahead_;
  Twist velocity_;
  double heading_rad_ = 0.0;
  Twist free_;                // the velocity of the next step if nothing acts on it
  Impact* impact_ = nullptr;  // of this step
  Undercarriage wheels_;      // if it has wheels
  std::shared_ptr<const Sled> sled_;
  double reach_ = 0.0;
  Footing footing_ = Footing::slides;
};

}  // namespace elsie::physics
