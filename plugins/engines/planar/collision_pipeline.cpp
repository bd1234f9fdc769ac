#include "collision_pipeline.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace elsie::physics {
namespace {

constexpr std::uint32_t kNone = Contact::kFixed;

// Bodies in the share of a thread; fewer are not worth waking it.
constexpr std::size_t kLeastColliders = 32;
constexpr std::size_t kLeastIslands = 4;

// A body that would come this deep into others has no room before a box that nothing stops.
constexpr double kDeepest = 2e-3;  // m
// Bodies that come nearer by less than this in a step are not pressed.
constexpr double kPressing = 1e-6;  // m

}  // namespace

bool CollisionPipeline::may_meet(std::uint32_t first, std::uint32_t second) const {
  const Collider &a = colliders_[first], &b = colliders_[second];
  const bool is_dynamic = (a.mover != kNone && movers_[a.mover].is_dynamic()) ||
                          (b.mover != kNone && movers_[b.mover].is_dynamic());
  // The limits of their joint keep neighbours apart.
  const bool neighbours =
      a.body == b.body && a.vehicle + 1 >= b.vehicle && b.vehicle + 1 >= a.vehicle;
  if (!is_dynamic || neighbours) return false;
  return joined_.empty() ||
         !std::binary_search(joined_.begin(), joined_.end(),
                             std::pair(std::min(first, second), std::max(first, second)));
}

/// An order that does not depend on the numbers of the bodies.
bool CollisionPipeline::is_before(const Collider& a, const Collider& b) const {
  if (a.mover == kNone || b.mover == kNone) return a.mover != kNone;
  const Vector2 &at_a = movers_[a.mover].place(), &at_b = movers_[b.mover].place();
  return std::tie(at_a.x, at_a.y, a.number) < std::tie(at_b.x, at_b.y, b.number);
}

void CollisionPipeline::find(std::span<const Moving> moving, double margin,
                             base::ThreadPool& pool) {
  found_.resize(pool.threads());
  scene_.begin_search();
  pool.divide(moving.size(), kLeastColliders, [&](const base::ThreadPool::Share& share) {
    for (std::size_t i = share.first; i < share.end; ++i) {
      if (scene_.is_clear(moving[i].collider, margin)) continue;
      find_contacts_of(moving[i], margin, found_[share.thread]);
    }
  });
  margin_ = margin;
  contacts_.clear();
  std::swap(contacts_, found_.front().contacts);
  for (Found& each : found_) {
    contacts_.insert(contacts_.end(), each.contacts.begin(), each.contacts.end());
    touches_.insert(touches_.end(), each.touches.begin(), each.touches.end());
    each.contacts.clear();
    each.touches.clear();
  }
  std::sort(touches_.begin(), touches_.end());
  // Several of a robot's vehicles may touch the same body.
  touches_.erase(std::unique(touches_.begin(), touches_.end()), touches_.end());
}

void CollisionPipeline::find_contacts_of(const Moving& moving, double margin, Found& found) const {
  const std::uint32_t id = moving.collider;
  std::vector<std::uint32_t>& near = found.near;
  near.clear();
  scene_.for_each_near(id, margin, [&](std::uint32_t other) {
    // Two movers find each other.
    if (colliders_[other].mover == kNone || id < other) near.push_back(other);
  });
  if (near.empty()) return;
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const std::uint32_t other : near) {
    const Collider &a = colliders_[id], &b = colliders_[other];
    if (!may_meet(id, other)) continue;
    const double nearer = b.mover == kNone ? 0.5 * margin : margin;  // only one of them moves
    if (is_before(a, b)) {
      meet(id, other, nearer, found);
    } else {
      meet(other, id, nearer, found);
    }
  }
}

void CollisionPipeline::meet(std::uint32_t first, std::uint32_t second, double margin,
                             Found& found) const {
  const Collider &a = colliders_[first], &b = colliders_[second];
  bool touches = false;
  for_each_meeting(
      *a.solids, clearance_.placement(first), *b.solids, clearance_.placement(second), margin,
      found.space, [&](std::size_t i, std::size_t k, const Meeting& met) {
        for (std::size_t n = 0; n < met.count; ++n) {
          Contact& contact = found.contacts.emplace_back();
          contact.key = {a.number, b.number, Contact::Key::of(i, k, met.points[n].feature)};
          contact.a = a.mover;
          contact.b = b.mover;
          contact.collider_a = first;
          contact.collider_b = second;
          contact.at = met.points[n].at;
          contact.normal = met.normal;
          contact.gap = met.points[n].gap;
          touches = touches || contact.gap <= kTouching;
        }
      });
  if ((touches || pushed(a.number, b.number)) && a.body != b.body) {
    found.touches.push_back(a.body < b.body ? Touch{a.body, b.body} : Touch{b.body, a.body});
  }
}

/// Whether they pushed each other in the last step; perhaps they have bounced off since.
bool CollisionPipeline::pushed(std::uint64_t a, std::uint64_t b) const {
  for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
    const Contact::Key least{first, second, 0};
    for (auto known = std::lower_bound(
             cache_.begin(), cache_.end(), least,
             [](const CachedContact&m, const Contact::Key&key) { return m.key < key; });
         known != cache_.end() && known->key.a == first && known->key.b == second; ++known) {
      if (known->normal_impulse > 0.0) return true;
    }
  }
  return false;
}

void CollisionPipeline::recall(Contact& contact) const {
  const auto known =
      std::lower_bound(cache_.begin(), cache_.end(), contact.key,
                       [](const CachedContact& m, const Contact::Key& key) { return m.key < key; });
  if (known == cache_.end() || known->key != contact.key) return;
  contact.normal_impulse = known->normal_impulse;
  contact.friction_impulse = known->friction_impulse;
  contact.coming = known->coming;
  contact.stored = known->stored;
}

std::uint32_t CollisionPipeline::root(std::uint32_t mover) {
  while (parents_[mover] != mover) {
    mover = parents_[mover] = parents_[parents_[mover]];
  }
  return mover;
}

void CollisionPipeline::join(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t of_a = root(a), of_b = root(b);
  if (of_a != of_b) parents_[std::max(of_a, of_b)] = std::min(of_a, of_b);
}

void CollisionPipeline::involve(std::uint32_t mover) {
  if (parents_[mover] != kNone) return;
  parents_[mover] = mover;
  involved_.push_back(mover);
}

void CollisionPipeline::order(std::span<Hinge* const> hinges) {
  for (const std::uint32_t mover : involved_) parents_[mover] = kNone;
  involved_.clear();
  parents_.resize(movers_.size(), kNone);
  ranks_.resize(movers_.size());
  const auto link = [this](std::uint32_t a, std::uint32_t b) {
    involve(a);
    if (b == kNone) return;
    involve(b);
    // A box that nothing stops passes nothing on.
    if (movers_[a].is_dynamic() && movers_[b].is_dynamic()) join(a, b);
  };
  for (const Contact& contact : contacts_) link(contact.a, contact.b);
  for (const Hinge* const hinge : hinges) link(hinge->front, hinge->behind);
  std::sort(involved_.begin(), involved_.end(), [this](std::uint32_t a, std::uint32_t b) {
    const Vector2 &at_a = movers_[a].place(), &at_b = movers_[b].place();
    return std::tie(at_a.x, at_a.y, a) < std::tie(at_b.x, at_b.y, b);
  });
  impacts_.resize(involved_.size());
  for (std::uint32_t i = 0; i < involved_.size(); ++i) {
    ranks_[involved_[i]] = i;
    movers_[involved_[i]].enter(physics_.step, impacts_[i]);
  }
  in_order_.clear();
  for (const Contact& contact : contacts_) {
    const bool is_of_a = movers_[contact.a].is_dynamic();
    in_order_.push_back({root(is_of_a ? contact.a : contact.b),
                         solver_.is_driven(contact),  // boxes that nothing stops come last
                         ranks_[contact.a], contact.b == kNone ? kNone : ranks_[contact.b],
                         contact.at.x, contact.at.y, contact.key.feature, contact.key.b,
                         in_order_.size()});
  }
  std::sort(in_order_.begin(), in_order_.end());
  sorted_.clear();
  for (const ContactPlace& place : in_order_) sorted_.push_back(contacts_[std::get<8>(place)]);
  std::swap(contacts_, sorted_);
  std::sort(involved_.begin(), involved_.end(), [this](std::uint32_t a, std::uint32_t b) {
    return std::pair(root(a), ranks_[a]) < std::pair(root(b), ranks_[b]);
  });
  hinges_.assign(hinges.begin(), hinges.end());
  std::sort(hinges_.begin(), hinges_.end(), [this](const Hinge* a, const Hinge* b) {
    return std::pair(root(a->front), ranks_[a->front]) <
           std::pair(root(b->front), ranks_[b->front]);
  });
}

void CollisionPipeline::solve(std::span<Hinge* const> hinges, base::ThreadPool& pool) {
  presses_.clear();
  if (contacts_.empty() && hinges.empty()) {
    cache_.clear();
    return;
  }
  order(hinges);
  islands_.clear();
  auto contact = contacts_.begin();
  auto hinge = hinges_.begin();
  for (auto first = involved_.begin(); first != involved_.end();) {
    const std::uint32_t island = root(*first);
    const auto last = std::find_if(first, involved_.end(),
                                   [&](std::uint32_t mover) { return root(mover) != island; });
    const auto last_contact = std::find_if(contact, contacts_.end(), [&](const Contact& each) {
      return root(movers_[each.a].is_dynamic() ? each.a : each.b) != island;
    });
    const auto last_hinge = std::find_if(
        hinge, hinges_.end(), [&](const Hinge* each) { return root(each->front) != island; });
    islands_.push_back({{first, last}, {contact, last_contact}, {hinge, last_hinge}});
    first = last;
    contact = last_contact;
    hinge = last_hinge;
  }
  pool.divide(islands_.size(), kLeastIslands, [this](const base::ThreadPool::Share& share) {
    for (std::size_t i = share.first; i < share.end; ++i) {
      solve_island(islands_[i], found_[share.thread]);
    }
  });
  for (Found& each : found_) {
    presses_.insert(presses_.end(), each.presses.begin(), each.presses.end());
    each.presses.clear();
  }
  cache_.clear();
  for (const Contact& each : contacts_) {
    if (each.normal_impulse > 0.0 || each.coming > 0.0) {
      cache_.push_back(
          {each.key, each.normal_impulse, each.friction_impulse, each.coming, each.stored});
    }
  }
  std::sort(cache_.begin(), cache_.end(),
            [](const CachedContact& a, const CachedContact& b) { return a.key < b.key; });
}

void CollisionPipeline::solve_island(const Island& island, Found& found) {
  const auto& [bodies, contacts, hinges] = island;
  for (Contact& contact : contacts) recall(contact);
  const bool act =
      !hinges.empty() || std::any_of(contacts.begin(), contacts.end(), [&](const Contact& contact) {
        return contact.gap < 0.0 || contact.coming > 0.0 || solver_.is_needed(contact);
      });
  bool kept = true;
  if (act) {
    kept = solver_.solve(bodies, contacts, hinges);
    if (const auto press = find_press(contacts)) {
      // Perhaps they only do not find out of each other's friction.
      kept = false;
      solver_.slip(bodies, contacts, hinges);
      if (find_press(contacts)) found.presses.push_back(*press);
    }
  } else {
    for (Contact& contact : contacts) contact.normal_impulse = contact.friction_impulse = 0.0;
  }
  const double part = clearance_.part(bodies, contacts, kept, margin_, found.space);
  if (act) solver_.separate(bodies, contacts, part);
  for (const std::uint32_t body : bodies) {
    if (part < 1.0) {
      movers_[body].stop_after(part);
    } else if (!act) {
      movers_[body].release();
    }
  }
}

/// A box that nothing stops and a body to which it leaves no room, if any.
std::optional<CollisionPipeline::Press> CollisionPipeline::find_press(
    std::span<const Contact> contacts) const {
  // Their contacts come last.
  if (contacts.empty() || !solver_.is_driven(contacts.back())) return std::nullopt;
  const Contact* presser = nullptr;
  double deepest = 0.0;
  for (const Contact& contact : contacts) {
    if (solver_.is_driven(contact) && contact.normal_impulse > 0.0 &&
        (!presser || contact.normal_impulse > presser->normal_impulse)) {
      presser = &contact;
    }
    const double nearer = -physics_.step * solver_.parting(contact);
    if (nearer > kPressing) deepest = std::max(deepest, nearer - contact.gap);
  }
  if (!presser || deepest <= kDeepest) return std::nullopt;
  const bool is_of_a = movers_[presser->a].is_dynamic();
  return Press{is_of_a ? presser->collider_a : presser->collider_b,
               is_of_a ? presser->collider_b : presser->collider_a, deepest};
}

}  // namespace elsie::physics
