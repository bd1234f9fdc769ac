#include "clearance.h"

#include <algorithm>
#include <cmath>

namespace elsie::physics {
namespace {

constexpr double kRest = 1e-4;           // m, instead of kSlop if they are so deep already
constexpr double kLeastAdvance = 0.025;  // of a step

double length(const Vector2& v) { return std::sqrt(v.x * v.x + v.y * v.y); }

}  // namespace

Placement Clearance::placement(std::uint32_t collider, double part) const {
  const std::uint32_t mover = colliders_[collider].mover;
  return mover == Contact::kFixed ? placement(collider) : movers_[mover].after(part, physics_.step);
}

/// The gap between two bodies after a part of the step, or `margin` if it is wider.
double Clearance::gap(const Pair& pair, double part, double margin, PairingSpace& space) const {
  double least = margin;
  for_each_meeting(*colliders_[pair.a].solids, placement(pair.a, part), *colliders_[pair.b].solids,
                   placement(pair.b, part), margin, space,
                   [&](std::size_t, std::size_t, const Meeting& met) {
                     for (std::size_t n = 0; n < met.count; ++n) {
                       least = std::min(least, met.points[n].gap);
                     }
                   });
  return least;
}

double Clearance::part(const Pair& pair, double most, PairingSpace& space) const {
  const Twist still;
  const auto twist = [&](std::uint32_t collider) {
    const std::uint32_t mover = colliders_[collider].mover;
    return mover == Contact::kFixed ? still : movers_[mover].moving();
  };
  const auto turning = [&](std::uint32_t collider) {
    const std::uint32_t mover = colliders_[collider].mover;
    if (mover == Contact::kFixed) return 0.0;
    const Mover& m = movers_[mover];
    return std::abs(m.moving().turn) * (m.reach() + length(m.inertia().center));
  };
  const Twist a = twist(pair.a), b = twist(pair.b);
  // The most by which they come nearer in the whole step.
  const double nearer =
      physics_.step * (length({a.x - b.x, a.y - b.y}) + turning(pair.a) + turning(pair.b));
  const double least = std::min(pair.gap - kRest, -kSlop);
  double part = 0.0, gap = pair.gap;
  while (gap - least < (most - part) * nearer) {
    const double next = std::min(most, part + std::max(kLeastAdvance, (gap - least) / nearer));
    gap = this->gap(pair, next, nearer, space);
    if (gap < least) return part;
    part = next;
  }
  return most;
}

double Clearance::part(std::span<const std::uint32_t> bodies, std::span<const Contact> contacts,
                       bool kept, double margin, PairingSpace& space) const {
  const double step = physics_.step;
  double most = 1.0;
  double aside = 0.0;  // m, how far points may be from where they would be without turning
  for (const std::uint32_t body : bodies) {
    const Mover& mover = movers_[body];
    const Twist& v = mover.moving();
    const double angle = step * std::abs(v.turn), way = step * length({v.x, v.y});
    const double edge = angle * mover.reach();
    aside = std::max(aside, angle * (way + edge));  // of two bodies
    // Farther away, nobody has looked for others.
    if (mover.is_dynamic() && most * (way + edge) > 0.5 * margin) {
      most = 0.5 * margin / (way + edge);
    }
  }
  const auto may_enter = [&](const Contact& contact) {
    return step * solver_.parting(contact) - aside < std::min(0.0, -contact.gap) - kSlop;
  };
  if (kept && aside <= kSlop) return most;
  if (std::none_of(contacts.begin(), contacts.end(), may_enter)) return most;
  for (auto contact = contacts.begin(); contact != contacts.end();) {
    Pair pair{contact->collider_a, contact->collider_b, contact->gap};
    for (; contact != contacts.end() && contact->collider_a == pair.a &&
           contact->collider_b == pair.b;
         ++contact) {
      pair.gap = std::min(pair.gap, contact->gap);
    }
    most = std::min(most, part(pair, most, space));
  }
  return most;
}

}  // namespace elsie::physics
