#include "contact_finder.h"

#include <algorithm>

#include "crowd.h"
#include "narrow_phase.h"

namespace elsie::physics {
namespace {

constexpr std::size_t kBlock = ContactFinder::kBlock;

std::size_t blocks_of(std::size_t items) { return (items + kBlock - 1) / kBlock; }

// The limits of their joint keep neighbours apart. No contact is reported when a robot touches
// itself.
bool meet_own(OdeContacts& contacts, const OdeRobot& robot, std::size_t a, std::size_t b) {
  if (std::max(a, b) - std::min(a, b) > 1) {
    meet_vehicles(contacts, robot.vehicles()[a].solids(), robot.vehicles()[b].solids());
  }
  return false;
}

bool meet(OdeContacts& contacts, const OdeBodies& bodies, Scene::Id first, Scene::Id second) {
  const Scene& scene = bodies.scene;
  const Body a = scene.body(first), b = scene.body(second);
  const auto vehicle = [&](Scene::Id id) -> const Vehicle& {
    return bodies.robots[scene.body(id).index].vehicles()[scene.part(id)].solids();
  };
  if (a.kind == BodyKind::robot && b.kind == BodyKind::robot) {
    if (a == b) {
      return meet_own(contacts, bodies.robots[a.index], scene.part(first), scene.part(second));
    }
    return meet_vehicles(contacts, vehicle(first), vehicle(second));
  }
  if (a.kind == BodyKind::robot) {
    return !bodies.holds(a, b) &&
           meet_vehicle_and_box(contacts, vehicle(first), bodies.box_of(b).solid());
  }
  if (b.kind == BodyKind::robot) {
    return !bodies.holds(b, a) &&
           meet_vehicle_and_box(contacts, vehicle(second), bodies.box_of(a).solid());
  }
  const BoxBody &box_a = bodies.box_of(a), &box_b = bodies.box_of(b);
  return (box_a.gives_way() || box_b.gives_way()) &&
         meet_solids(contacts, box_a.solid(), box_b.solid());
}

/// Gives each of the watched contacts a place for its impulse.
void prepare_impulses(FoundContacts& found) {
  const std::span<FoundContact> contacts = found.contacts.found();
  found.impulses.assign(contacts.size(), {});
  for (const FoundContacts::Watched& pair : found.watched) {
    for (std::size_t i = pair.first; i < pair.last; ++i) contacts[i].impulse = &found.impulses[i];
  }
}

double gap_of(const FoundContact& contact, double step) {
  const dSurfaceParameters& surface = contact.contact.surface;
  return surface.mode & dContactMotionN ? -step * surface.motionN : -contact.contact.geom.depth;
}

}  // namespace

ContactFinder::ContactFinder(const world::Physics& physics)
    : physics_(physics), floor_(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0)) {}

void ContactFinder::find(const OdeBodies& bodies, const ContactWatch& watch,
                         base::ThreadPool& pool) {
  const std::size_t on_floor = blocks_of(bodies.robots.size()) + 1;
  const std::size_t pairs = blocks_of(bodies.mobile.size());
  used_ = on_floor + pairs;
  while (blocks_.size() < used_) blocks_.push_back({OdeContacts(physics_), {}, {}, {}, {}});
  for (FoundContacts& some : found()) {
    some.contacts.clear();
    some.touches.clear();
    some.watched.clear();
  }
  find_floor(bodies, pool);
  pool.divide(pairs, 1, [&](const base::ThreadPool::Share& share) {
    prepare_ode();
    const std::size_t end = std::min(bodies.mobile.size(), kBlock * share.end);
    for (std::size_t i = kBlock * share.first; i < end; ++i) {
      find_neighbors(bodies, watch, bodies.mobile[i], blocks_[on_floor + i / kBlock]);
    }
  });

  for (FoundContacts& some : found()) {
    if (!some.watched.empty()) prepare_impulses(some);
  }
  touches_.clear();
  for (const FoundContacts& some : found().subspan(on_floor)) {
    touches_.insert(touches_.end(), some.touches.begin(), some.touches.end());
  }
  std::sort(touches_.begin(), touches_.end());
  // Several of a robot's vehicles may touch the same body.
  touches_.erase(std::unique(touches_.begin(), touches_.end()), touches_.end());
}

void ContactFinder::find_floor(const OdeBodies& bodies, base::ThreadPool& pool) {
  const std::size_t robots = bodies.robots.size();
  pool.divide(blocks_of(robots), 1, [&](const base::ThreadPool::Share& share) {
    prepare_ode();
    for (std::size_t i = kBlock * share.first; i < std::min(robots, kBlock * share.end); ++i) {
      bodies.robots[i].meet_floor(blocks_[i / kBlock].contacts, floor_.get());
    }
  });
  OdeContacts& of_boxes = blocks_[blocks_of(robots)].contacts;
  for (const BoxBody& box : bodies.boxes) {
    if (box.present && box.gives_way() && !box.is_carried()) box.meet_floor(of_boxes);
  }
}

void ContactFinder::find_neighbors(const OdeBodies& bodies, const ContactWatch& watch, Scene::Id id,
                                   FoundContacts& found) const {
  bodies.scene.neighbors(id, found.neighbors);
  for (const Scene::Id other : found.neighbors) {
    const Body a = bodies.scene.body(id), b = bodies.scene.body(other);
    if (other < id && bodies.is_mobile(b)) continue;  // already met
    const std::size_t first = found.contacts.found().size();
    if (meet(found.contacts, bodies, id, other)) {
      found.touches.push_back(a < b ? Touch{a, b} : Touch{b, a});
    }
    const std::size_t last = found.contacts.found().size();
    if (first < last && a != b && (watch.watches(a) || watch.watches(b))) {
      found.watched.push_back({id, other, first, last});
    }
  }
}

Vector3 ContactFinder::impulse_on_a(const FoundContact& contact) const {
  const ContactImpulse& impulse = *contact.impulse;
  if (impulse.crowd) return impulse.crowd->impulse(impulse);
  // ODE's first body is b if there is no a.
  return (contact.a ? physics_.step : -physics_.step) * to_vector(impulse.joint.f1);
}

void ContactFinder::note(const OdeBodies& bodies, ContactWatch& watch) {
  std::uint64_t number = 0;
  for (FoundContacts& some : found()) {
    for (const FoundContacts::Watched& pair : some.watched) {
      for (std::size_t i = pair.first; i < pair.last; ++i) {
        const FoundContact& contact = some.contacts.found()[i];
        const Vector3 normal = to_vector(contact.contact.geom.normal);
        const Vector3 on_a = impulse_on_a(contact);
        if (gap_of(contact, physics_.step) > kTouching && dot(on_a, normal) <= 0.0) continue;
        const auto note = [&](Scene::Id own, Scene::Id other) {
          const Body body = bodies.scene.body(own);
          if (!watch.watches(body)) return;
          const dBodyID chassis = bodies.robots[body.index].vehicles().front().chassis();
          const bool is_a = contact.a && contact.member_a == dBodyGetData(chassis);
          const double side = is_a ? 1.0 : -1.0;
          watch.note(body.index, {number++, 0, 0},
                     {bodies.scene.part(own), bodies.scene.body(other),
                      to_vector(contact.contact.geom.pos), side * normal, side * on_a});
        };
        note(pair.a, pair.b);
        note(pair.b, pair.a);
      }
    }
  }
}

}  // namespace elsie::physics
