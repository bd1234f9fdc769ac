#include "contact_solver.h"

#include <algorithm>
#include <cmath>

#include "elsie/world/engine_facts.h"

namespace elsie::physics {
namespace {

constexpr int kMostSweeps = 60;
constexpr int kSeparations = 4;
constexpr double kLeastDepth = 5e-6;  // m; smaller overlaps are not corrected
constexpr double kSettled = 1e-7;     // m/s: changes below this end the sweeps
constexpr int kWeakenings = 10;       // of the bounces of an island
constexpr double kMostGain = 1e-4;    // of the energy that bounces return, and contacts take
constexpr int kMostSlipping = 2000;   // sweeps
constexpr int kScalings = 8;          // of the impulses of an island

Twist at_point(const Vector2& direction, const Vector2& from) {
  return {direction.x, direction.y, from.x * direction.y - from.y * direction.x};
}

}  // namespace

double ContactSolver::bounce_threshold() const {
  return 2.0 * std::abs(physics_.gravity) * physics_.step;
}

Contact::Row ContactSolver::row(const Contact& contact, const Vector2& direction) const {
  Contact::Row row;
  const Mover& a = movers_[contact.a];
  row.a = at_point(direction, minus(contact.at, a.center()));
  row.change_a = a.response() * row.a;
  double inverse = dot(row.a, row.change_a);  // of the effective mass
  if (contact.b != Contact::kFixed) {
    const Mover& b = movers_[contact.b];
    row.b = -1.0 * at_point(direction, minus(contact.at, b.center()));
    row.change_b = b.response() * row.b;
    inverse += dot(row.b, row.change_b);
  }
  row.mass = inverse > 0.0 ? 1.0 / inverse : 0.0;
  return row;
}

inline double ContactSolver::speed(const Contact& contact, const Contact::Row& row) const {
  double speed = dot(row.a, movers_[contact.a].moving());
  if (contact.b != Contact::kFixed) speed += dot(row.b, movers_[contact.b].moving());
  return speed;
}

double ContactSolver::parting(const Contact& contact) const {
  const Mover& a = movers_[contact.a];
  double speed = dot(at_point(contact.normal, minus(contact.at, a.center())), a.moving());
  if (contact.b == Contact::kFixed) return speed;
  const Mover& b = movers_[contact.b];
  return speed - dot(at_point(contact.normal, minus(contact.at, b.center())), b.moving());
}

bool ContactSolver::is_needed(const Contact& contact) const {
  return physics_.step * parting(contact) < -std::max(contact.gap, 0.0);
}

bool ContactSolver::is_driven(const Contact& contact) const {
  return !movers_[contact.a].is_dynamic() ||
         (contact.b != Contact::kFixed && !movers_[contact.b].is_dynamic());
}

void ContactSolver::prepare(Contact& contact) const {
  contact.across = row(contact, contact.normal);
  contact.along = row(contact, {-contact.normal.y, contact.normal.x});
}

inline void ContactSolver::apply(const Contact& contact, const Contact::Row& row, double impulse) {
  // A box that nothing stops takes no impulse, and other islands meet it, too.
  Mover& a = movers_[contact.a];
  if (a.is_dynamic()) a.add(impulse * row.a, impulse * row.change_a);
  if (contact.b == Contact::kFixed) return;
  Mover& b = movers_[contact.b];
  if (b.is_dynamic()) b.add(impulse * row.b, impulse * row.change_b);
}

void ContactSolver::aim(Contact& contact) const {
  contact.parted = parting(contact);
  // Other bodies have turned them back before they met.
  if (contact.gap > kTouching && contact.parted >= 0.0) contact.coming = contact.stored = 0.0;
  const double coming = std::max(contact.coming, -contact.parted);
  const bool bounces = physics_.bounce > 0.0 && coming > bounce_threshold();
  contact.target = contact.gap > kTouching ? -contact.gap / physics_.step
                   : bounces               ? physics_.bounce * coming
                                           : 0.0;
  contact.coming = bounces && contact.gap > kTouching ? coming : 0.0;
  contact.slid = speed(contact, contact.along);
}

void ContactSolver::warm(Contact& contact) {
  apply(contact, contact.across, contact.normal_impulse);
  apply(contact, contact.along, contact.friction_impulse);
}

double ContactSolver::relax(Contact& contact, double friction) {
  const double off = contact.target - speed(contact, contact.across);
  const double normal = std::max(0.0, contact.normal_impulse + contact.across.mass * off);
  const double pushed = normal - contact.normal_impulse;
  contact.normal_impulse = normal;
  if (pushed != 0.0) apply(contact, contact.across, pushed);

  const double most = friction * normal;
  const double sliding = speed(contact, contact.along);
  const double tangential =
      std::clamp(contact.friction_impulse - contact.along.mass * sliding, -most, most);
  const double braked = tangential - contact.friction_impulse;
  contact.friction_impulse = tangential;
  if (braked != 0.0) apply(contact, contact.along, braked);
  return std::max(contact.across.mass > 0.0 ? std::abs(pushed) / contact.across.mass : 0.0,
                  contact.along.mass > 0.0 ? std::abs(braked) / contact.along.mass : 0.0);
}

void ContactSolver::prepare(Hinge& hinge) const {
  const Mover &front = movers_[hinge.front], &behind = movers_[hinge.behind];
  // The middle of the arcs, so that both ends of the joint move alike along their arcs.
  const auto arm = [](const Mover& mover, const Vector2& end) {
    return mover.middle().turn(minus(end, mover.inertia().center));
  };
  hinge.from_front = arm(front, hinge.front_end);
  hinge.from_behind = arm(behind, hinge.behind_end);
  hinge.kxx = hinge.kxy = hinge.kyy = 0.0;
  const auto add = [&](const Mover& mover, const Vector2& from) {
    const Twist x = at_point({1.0, 0.0}, from), y = at_point({0.0, 1.0}, from);
    const Twist by_x = mover.response() * x, by_y = mover.response() * y;
    hinge.kxx += dot(x, by_x);
    hinge.kxy += dot(y, by_x);
    hinge.kyy += dot(y, by_y);
  };
  add(front, hinge.from_front);
  add(behind, hinge.from_behind);
  hinge.turn_mass = 1.0 / (front.response().tt + behind.response().tt);
}

void ContactSolver::warm(Hinge& hinge) {
  Mover &front = movers_[hinge.front], &behind = movers_[hinge.behind];
  const auto act = [](Mover& mover, const Twist& impulse) {
    mover.add(impulse, mover.response() * impulse);
  };
  act(behind, at_point(hinge.pull, hinge.from_behind) + Twist{0.0, 0.0, hinge.twist});
  act(front, -1.0 * (at_point(hinge.pull, hinge.from_front) + Twist{0.0, 0.0, hinge.twist}));
}

/// The joint's two equations at once: with the velocities u of the joint's end at either body, and
/// the way d from the end in front to the one behind,
///
///   K pull = -(u_behind - u_front + erp d / h),   K = J A J' of both bodies, a matrix of 2 x 2.
///
/// Its motor or limit is a row in the turning alone.
double ContactSolver::relax(Hinge& hinge) {
  Mover &front = movers_[hinge.front], &behind = movers_[hinge.behind];
  const auto act = [](Mover& mover, const Twist& impulse) {
    mover.add(impulse, mover.response() * impulse);
  };
  // The motor, or a limit.
  const double step = physics_.step, rate = behind.moving().turn - front.moving().turn;
  double twist = 0.0;
  if (hinge.joint.torque > 0.0) {
    const double wanted = std::clamp((hinge.wanted_yaw_rad - hinge.yaw_rad) / step,
                                     -hinge.joint.yaw_rate_rad_s, hinge.joint.yaw_rate_rad_s);
    const double most = step * hinge.joint.torque;
    twist = std::clamp(hinge.twist + hinge.turn_mass * (wanted - rate), -most, most);
  } else {
    const double least = (-hinge.joint.max_yaw_rad - hinge.yaw_rad) / step;
    const double most = (hinge.joint.max_yaw_rad - hinge.yaw_rad) / step;
    // The impulse of the limit that either end would need.
    const double up = hinge.twist + hinge.turn_mass * (least - rate);
    const double down = hinge.twist + hinge.turn_mass * (most - rate);
    twist = up > 0.0 ? up : down < 0.0 ? down : 0.0;
  }
  const Twist turned{0.0, 0.0, twist - hinge.twist};
  hinge.twist = twist;
  if (turned.turn != 0.0) {
    act(behind, turned);
    act(front, -1.0 * turned);
  }

  const auto velocity = [](const Mover& mover, const Vector2& from) {
    const Twist& v = mover.moving();
    return Vector2{v.x - v.turn * from.y, v.y + v.turn * from.x};
  };
  Vector2 apart = minus(velocity(behind, hinge.from_behind), velocity(front, hinge.from_front));
  apart = {apart.x + erp_ / step * hinge.apart.x, apart.y + erp_ / step * hinge.apart.y};
  const double determinant = hinge.kxx * hinge.kyy - hinge.kxy * hinge.kxy;
  if (!(determinant > 0.0)) return 0.0;
  const Vector2 pull{-(hinge.kyy * apart.x - hinge.kxy * apart.y) / determinant,
                     -(hinge.kxx * apart.y - hinge.kxy * apart.x) / determinant};
  hinge.pull = {hinge.pull.x + pull.x, hinge.pull.y + pull.y};
  act(behind, at_point(pull, hinge.from_behind));
  act(front, -1.0 * at_point(pull, hinge.from_front));
  return std::max(std::abs(apart.x), std::abs(apart.y));
}

void ContactSolver::prepare(std::span<Contact> contacts, std::span<Hinge* const> hinges) const {
  for (Hinge* const hinge : hinges) prepare(*hinge);
  for (Contact& contact : contacts) prepare(contact);
}

bool ContactSolver::sweep(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
                          std::span<Hinge* const> hinges, double friction, int most) {
  bool settled = false;
  for (int sweep = 0; sweep < most && !settled; ++sweep) {
    double changed = 0.0;
    bool is_looser = false;
    for (const std::uint32_t body : bodies) {
      const Mover::Stand stood = movers_[body].stand();
      changed = std::max(changed, stood.changed);
      is_looser = is_looser || stood.is_looser;
    }
    if (is_looser) prepare(contacts, hinges);
    for (Hinge* const hinge : hinges) changed = std::max(changed, relax(*hinge));
    if (sweep % 2 == 0) {
      for (Contact& contact : contacts) changed = std::max(changed, relax(contact, friction));
    } else {
      for (auto contact = contacts.rbegin(); contact != contacts.rend(); ++contact) {
        changed = std::max(changed, relax(*contact, friction));
      }
    }
    settled = changed < kSettled;
  }
  for (Contact& contact : contacts) {
    if (is_driven(contact)) relax(contact, friction);
  }
  return settled;
}

/// With the factor s of all impulses, the power of the contacts is at most s (free + s (now -
/// free)), which is not positive up to s = free / (free - now).
void ContactSolver::limit_power(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
                                std::span<Hinge* const> hinges) {
  for (int i = 0; i <= kScalings; ++i) {
    for (const std::uint32_t body : bodies) movers_[body].stand();
    if (i == kScalings) return;
    // With the velocities to these impulses, and to none.
    double now = 0.0, free = 0.0;
    for (const Contact& contact : contacts) {
      const double returned = contact.normal_impulse * std::max(contact.target, 0.0);
      now += contact.normal_impulse * speed(contact, contact.across) +
             contact.friction_impulse * speed(contact, contact.along) - returned;
      free += contact.normal_impulse * contact.parted + contact.friction_impulse * contact.slid -
              returned;
    }
    for (const Hinge* const hinge : hinges) {
      const Mover &front = movers_[hinge->front], &behind = movers_[hinge->behind];
      const auto pull = [&](const Twist& of_front, const Twist& of_behind) {
        return dot(at_point(hinge->pull, hinge->from_behind), of_behind) -
               dot(at_point(hinge->pull, hinge->from_front), of_front);
      };
      now += pull(front.moving(), behind.moving());
      free += pull(front.moving_freely(), behind.moving_freely());
    }
    if (now <= kMostGain * std::abs(free)) return;
    const double factor = free < 0.0 ? free / (free - now) : 0.0;
    for (const std::uint32_t body : bodies) movers_[body].scale(factor);
    for (Contact& contact : contacts) {
      contact.normal_impulse *= factor;
      contact.friction_impulse *= factor;
    }
    for (Hinge* const hinge : hinges) {
      hinge->pull = {factor * hinge->pull.x, factor * hinge->pull.y};
      hinge->twist *= factor;
    }
  }
}

/// The energy that the impulses of a contact add, J: exact if nothing but contacts acts.
double ContactSolver::work(const Contact& contact) const {
  return 0.5 * (contact.normal_impulse * (contact.parted + speed(contact, contact.across)) +
                contact.friction_impulse * (contact.slid + speed(contact, contact.along)));
}

/// The share by which bounces are too strong: so much more energy they return than contacts have
/// taken. 0: none.
double ContactSolver::excess(std::span<const Contact> contacts) const {
  double gained = 0.0, returned = 0.0;
  for (const Contact& contact : contacts) {
    const double more = work(contact) - contact.stored;
    gained += contact.coming > 0.0 ? std::max(0.0, more) : more;  // takes now, returns later
    returned += 0.5 * contact.normal_impulse * std::max(contact.target, 0.0);
  }
  const bool too_much = returned > 0.0 && gained > kMostGain * returned;
  return too_much ? std::min(gained / returned, 0.5) : 0.0;
}

bool ContactSolver::solve(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
                          std::span<Hinge* const> hinges) {
  prepare(contacts, hinges);
  for (Contact& contact : contacts) aim(contact);
  for (Contact& contact : contacts) warm(contact);
  for (Hinge* const hinge : hinges) warm(*hinge);
  bool settled = sweep(bodies, contacts, hinges, physics_.friction, kMostSweeps);
  if (physics_.bounce <= 0.0) {
    if (!settled) limit_power(bodies, contacts, hinges);
    return settled;
  }
  // Each contact bounces as if it were alone, and several of one body together may add energy.
  for (int i = 0; i < kWeakenings; ++i) {
    const double weaker = excess(contacts);
    if (!(weaker > 0.0)) break;
    for (Contact& contact : contacts) {
      if (contact.target > 0.0) contact.target *= 1.0 - weaker;
    }
    settled = sweep(bodies, contacts, hinges, physics_.friction, kMostSweeps);
  }
  if (!settled) limit_power(bodies, contacts, hinges);
  for (Contact& contact : contacts) {
    contact.stored = contact.coming > 0.0 ? std::max(0.0, contact.stored - work(contact)) : 0.0;
  }
  return settled;
}

void ContactSolver::slip(std::span<const std::uint32_t> bodies, std::span<Contact> contacts,
                         std::span<Hinge* const> hinges) {
  const bool settled = sweep(bodies, contacts, hinges, 0.0, kMostSlipping);
  if (!settled) limit_power(bodies, contacts, hinges);
}

/// How far shifts have moved the bodies of a contact apart, m.
double ContactSolver::shifted_apart(const Contact& contact) const {
  Vector2 moved = movers_[contact.a].shifted();
  if (contact.b != Contact::kFixed) moved = minus(moved, movers_[contact.b].shifted());
  return moved.x * contact.normal.x + moved.y * contact.normal.y;
}

void ContactSolver::separate(std::span<const std::uint32_t> bodies,
                             std::span<const Contact> contacts, double part) {
  bool moved = false;
  const auto inverse_mass = [this](std::uint32_t mover) {
    return mover != Contact::kFixed && movers_[mover].gives_way()
               ? 1.0 / movers_[mover].inertia().mass
               : 0.0;
  };
  for (int i = 0; i < kSeparations; ++i) {
    for (const Contact& contact : contacts) {
      if (contact.gap >= -kLeastDepth) continue;
      const double of_a = inverse_mass(contact.a), of_b = inverse_mass(contact.b);
      const double depth = -contact.gap - kLeastDepth - shifted_apart(contact);
      if (depth <= 0.0 || of_a + of_b == 0.0) continue;
      const double way =
          std::min(erp_ * depth, kMaxCorrectingSpeed * physics_.step) / (of_a + of_b);
      moved = true;
      if (of_a > 0.0) {
        movers_[contact.a].shift({way * of_a * contact.normal.x, way * of_a * contact.normal.y});
      }
      if (of_b > 0.0) {
        movers_[contact.b].shift({-way * of_b * contact.normal.x, -way * of_b * contact.normal.y});
      }
    }
  }
  if (!moved) return;
  double share = 1.0;
  for (const Contact& contact : contacts) {
    const double nearer = -shifted_apart(contact);
    const double gap = contact.gap + part * physics_.step * parting(contact);
    const double room = std::max(gap, 0.0) + kSlop;
    if (nearer > room) share = std::min(share, room / nearer);
  }
  if (share == 1.0) return;
  for (const std::uint32_t body : bodies) {
    const Vector2 by = movers_[body].shifted();
    movers_[body].shift({(share - 1.0) * by.x, (share - 1.0) * by.y});
  }
}

}  // namespace elsie::physics
