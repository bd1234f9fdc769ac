// The impulses between bodies that meet.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "elsie/world/description.h"

#include "mover.h"
#include "softness.h"

namespace elsie::physics {

/// Surfaces that are no further apart touch.
inline constexpr double kTouching = 2e-5;  // m

/// Bodies may enter each other by this much in a step.
inline constexpr double kSlop = 5e-4;  // m

/// A point at which two bodies meet, or will meet in this step.
struct Contact {
  static constexpr std::uint32_t kFixed = 0xffffffff;

  /// Names a contact from step to step, whatever else is in the world.
  struct Key {
    std::uint64_t a = 0, b = 0;  // the numbers of the bodies
    std::uint64_t feature = 0;   // of(), see there
    /// Solid `i` of one body meets solid `k` of the other at this point of a Meeting.
    static std::uint64_t of(std::size_t i, std::size_t k, std::uint32_t feature) {
      return static_cast<std::uint64_t>(i) << 48 | static_cast<std::uint64_t>(k) << 32 | feature;
    }
    std::size_t solid_of_a() const { return feature >> 48; }
    std::size_t solid_of_b() const { return feature >> 32 & 0xffff; }
    friend auto operator<=>(const Key&, const Key&) = default;  // NOLINT(modernize-use-nullptr)
  };

  Key key;
  std::uint32_t a = 0;       // a mover
  std::uint32_t b = kFixed;  // a mover, or a fixed body
  std::uint32_t collider_a = 0, collider_b = 0;
  Vector2 at;
  Vector2 normal;  // from b into a
  double gap = 0.0;

  double coming = 0.0;            // m/s, the speed at which they came nearer before they met
  double normal_impulse = 0.0;    // N s
  double friction_impulse = 0.0;  // N s, along the normal turned to the left
  double stored = 0.0;  // J, taken from the bodies since `coming`; the bounce returns at most this

  // Used by the solver only.
  double target = 0.0;
  double parted = 0.0, slid = 0.0;  // m/s, the speeds across and along without impulses
  struct Row {
    Twist a, b;                // velocities of the bodies to the speed of the row
    Twist change_a, change_b;  // impulse of the row to changes of velocity
    double mass = 0.0;         // kg, effective: of impulse to change of the speed
  };
  Row across, along;
};

/// The joint that pulls a vehicle, or by which a robot holds a box.
struct Hinge {
  std::uint32_t front = 0, behind = 0;  // movers
  Vector2 front_end, behind_end;        // m, in the frames of the movers
  HitchJoint joint;
  double yaw_rad = 0.0;
  double wanted_yaw_rad = 0.0;
  Vector2 apart;       // m, in the world: from the end in front to the end behind
  Vector2 pull;        // N s, of the last step
  double twist = 0.0;  // N m s, of the motor or of a limit

  // Used by the solver only.
  Vector2 from_front, from_behind;
  double kxx = 0.0, kxy = 0.0, kyy = 0.0;
  double turn_mass = 0.0;
};

/// Finds impulses that keep bodies from entering each other: projected Gauss-Seidel, beginning with
/// those of the last step (Catto, "Iterative Dynamics with Temporal Coherence", 2005). With the
/// normal's direction in J, the gap g and the friction mu, a contact has
///
///   p >= 0,   J v >= -g / h,   p (J v + g / h) = 0,   |p_t| <= mu p,   p_t along -J_t v,
///
/// or J v >= bounce times the speed of approach where they touch already. A sweep gives each row
/// the impulse that satisfies it alone:
///
///   p' = max(0, p + m (target - J v)),   m = 1 / (J A J'),   v' = v + A J' (p' - p).
///
/// A is not M^-1, but the change of velocity that wheels and the floor's friction let through
/// (Mover::response()): they are solved anew after each sweep, exactly, and contacts take account
/// of them from the start.
///
/// The sweeps need not converge: where much friction meets many bodies they may go round in a
/// circle. So the power of the impulses p at the velocities v(p) that follow from them is limited.
/// Contacts only take energy, so p J v(p) must not be positive. As tyres, motors and the floor's
/// friction answer monotonically, p J v(s p) grows with s, and s in [0, 1] scales all impulses of
/// the island so that it does not exceed zero. The velocities may then lead into other bodies;
/// Clearance keeps the places apart.
class ContactSolver {
 public:
  ContactSolver(const world::Physics& physics, std::vector<Mover>& movers)
      : physics_(physics), erp_(softness_of(physics).erp), movers_(movers) {}

  /// Solves an island; the bodies have been entered. Contacts and hinges are in a fixed order.
  /// Returns whether the velocities keep all contacts.
  bool solve(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
             std::span<Hinge* const> hinges);

  /// After solve(): solves once more without friction, as well as it can. Bodies that nothing but
  /// friction holds before a box that nothing stops slip away.
  void slip(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
            std::span<Hinge* const> hinges);

  /// Moves bodies that have entered each other a little apart, without a velocity, and not into
  /// others. All will move this part of their ways in this step.
  void separate(std::span<const std::uint32_t> bodies, std::span<const Contact> contacts,
                double part);

  /// True if the bodies would enter each other in this step without an impulse, or bounce.
  bool is_needed(const Contact& contact) const;
  /// True if one of the bodies is a box that nothing stops.
  bool is_driven(const Contact& contact) const;
  /// The speed at which they part, m/s.
  double parting(const Contact& contact) const;
  /// Bodies that come nearer at less than this do not bounce, m/s.
  double bounce_threshold() const;

 private:
  void prepare(Contact& contact) const;
  void prepare(Hinge& hinge) const;
  void aim(Contact& contact) const;
  void warm(Contact& contact);
  void warm(Hinge& hinge);
  double relax(Contact& contact, double friction);
  double relax(Hinge& hinge);
  /// Returns whether the velocities have settled.
  bool sweep(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
             std::span<Hinge* const> hinges, double friction, int most);
  void prepare(std::span<Contact> contacts, std::span<Hinge* const> hinges) const;
  void limit_power(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
                   std::span<Hinge* const> hinges);
  double work(const Contact& contact) const;
  double shifted_apart(const Contact& contact) const;
  double excess(std::span<const Contact> contacts) const;
  Contact::Row row(const Contact& contact, const Vector2& direction) const;
  // Short, and called in each sweep.
  [[gnu::always_inline]] void apply(const Contact& contact, const Contact::Row& row,
                                    double impulse);
  [[gnu::always_inline]] double speed(const Contact& contact, const Contact::Row& row) const;

  const world::Physics& physics_;
  double erp_;
  std::vector<Mover>& movers_;
};

}  // namespace elsie::physics
