#include "contact_finder.h"

#include <algorithm>

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
    return meet_vehicle_and_box(contacts, vehicle(first), bodies.box_of(b).solid());
  }
  if (b.kind == BodyKind::robot) {
    return meet_vehicle_and_box(contacts, vehicle(second), bodies.box_of(a).solid());
  }
  const BoxBody &box_a = bodies.box_of(a), &box_b = bodies.box_of(b);
  const bool can_give =
      box_a.kind == world::ObstacleKind::dynamic || box_b.kind == world::ObstacleKind::dynamic;
  return can_give && meet_solids(contacts, box_a.solid(), box_b.solid());
}

}  // namespace

ContactFinder::ContactFinder(const world::Physics& physics)
    : physics_(physics), floor_(dCreatePlane(nullptr, 0.0, 0.0, 1.0, 0.0)) {}

void ContactFinder::find(const OdeBodies& bodies, base::ThreadPool& pool) {
  const std::size_t on_floor = blocks_of(bodies.robots.size()) + 1;
  const std::size_t pairs = blocks_of(bodies.mobile.size());
  used_ = on_floor + pairs;
  while (blocks_.size() < used_) blocks_.push_back({OdeContacts(physics_), {}, {}});
  for (FoundContacts& some : found()) {
    some.contacts.clear();
    some.touches.clear();
  }
  find_floor(bodies, pool);
  pool.divide(pairs, 1, [&](const base::ThreadPool::Share& share) {
    prepare_ode();
    const std::size_t end = std::min(bodies.mobile.size(), kBlock * share.end);
    for (std::size_t i = kBlock * share.first; i < end; ++i) {
      find_neighbors(bodies, bodies.mobile[i], blocks_[on_floor + i / kBlock]);
    }
  });

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
    if (box.present && box.kind == world::ObstacleKind::dynamic) box.meet_floor(of_boxes);
  }
}

void ContactFinder::find_neighbors(const OdeBodies& bodies, Scene::Id id,
                                   FoundContacts& found) const {
  bodies.scene.neighbors(id, found.neighbors);
  for (const Scene::Id other : found.neighbors) {
    const Body a = bodies.scene.body(id), b = bodies.scene.body(other);
    if (other < id && bodies.is_mobile(b)) continue;  // already met
    if (meet(found.contacts, bodies, id, other)) {
      found.touches.push_back(a < b ? Touch{a, b} : Touch{b, a});
    }
  }
}

}  // namespace elsie::physics
