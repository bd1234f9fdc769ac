#include "islands.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace elsie::physics {
namespace {

// ODE's solver takes islands up to this size: six robots, or one with ten segments. A segment or a
// box has about half as many equations as a robot.
constexpr std::size_t kRobotSize = 2;
constexpr std::size_t kMostForOde = 6 * kRobotSize;

// In a heap of more long trains the matrix of all contacts fills up, and sweeps take less time.
constexpr std::size_t kMostEntangled = 8;

// If a body has two contacts more than it needs, their softness distributes its weight.
constexpr double kLeastCfm = 1e-10;

// ODE's solver gives up where two contacts of the same body reach their limits at the same instant,
// as on symmetrical bodies. So two successive contacts are never quite equal.
constexpr std::size_t kTies = 7;

std::size_t member_of(void* data) { return reinterpret_cast<std::uintptr_t>(data) - 1; }

}  // namespace

Islands::Islands(dWorldID world, const world::Physics& physics)
    : world_(world),
      joints_(dJointGroupCreate(0)),
      cfm_(std::max(softness_of(physics).cfm, kLeastCfm)),
      physics_(physics),
      crowd_(physics) {}

void Islands::add_robot(const OdeRobot& robot) {
  Member member;
  member.robot = robots_++;
  member.segments = robot.vehicles().size() - 1;
  member.size = kRobotSize + member.segments;
  robot.for_each_body([&](dBodyID body) { member.bodies.push_back(body); });
  add(std::move(member));
}

void Islands::add_obstacle(dBodyID box) {
  if (void* const data = dBodyGetData(box)) {  // it was removed, and is back
    members_[member_of(data)].bodies = {box};
    return;
  }
  Member member;
  member.bodies.push_back(box);
  add(std::move(member));
}

void Islands::add(Member member) {
  members_.push_back(std::move(member));
  // Numbers start at 1, because an ODE body without data has 0.
  const auto number = static_cast<std::uintptr_t>(members_.size());
  for (const dBodyID body : members_.back().bodies) {
    dBodySetData(body, reinterpret_cast<void*>(number));
  }
}

void Islands::remove_obstacle(dBodyID box) {
  members_[member_of(dBodyGetData(box))].bodies.clear();
}

/// Completes a contact. `number`: how many contacts of the step precede it.
void Islands::finish(FoundContact& contact, std::size_t number) const {
  dSurfaceParameters& surface = contact.contact.surface;
  const double unequal = static_cast<double>(number % kTies);
  surface.soft_cfm = softer_ * cfm_ * (1.0 + 1e-3 * unequal);
  surface.mu *= 1.0 + 1e-6 * unequal;
  surface.mu2 *= 1.0 + 1e-6 * unequal;
}

void Islands::divide(std::span<FoundContacts> found, const OdeBodies& bodies, OdeTakes takes) {
  sets_.reset(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) sets_.count(i, members_[i].size);
  for (FoundContacts& some : found) {
    for (const FoundContact& contact : some.contacts.found()) {
      if (contact.a && contact.b) {
        sets_.link(member_of(contact.member_a), member_of(contact.member_b));
      }
    }
  }
  for (const Grip& grip : bodies.grips.all()) {
    sets_.link(member_of(dBodyGetData(grip.chassis)), member_of(dBodyGetData(grip.body)));
  }
  choose_solvers(takes);
  for (Member& member : members_) {
    if (member.crowd) take_out(member, bodies.robots);
  }
  for (const Grip& grip : bodies.grips.all()) {
    Crowd* const crowd = members_[member_of(dBodyGetData(grip.body))].crowd;
    if (crowd) crowd->add_grip(grip);
  }
  std::size_t number = 0;
  for (FoundContacts& some : found) {
    for (FoundContact& contact : some.contacts.found()) {
      finish(contact, number++);
      if (Crowd* const crowd =
              members_[member_of(contact.a ? contact.member_a : contact.member_b)].crowd) {
        crowd->add_contact(contact);
      } else {
        const dJointID joint = dJointCreateContact(world_, joints_.get(), &contact.contact);
        dJointAttach(joint, contact.a, contact.b);
        if (contact.impulse) dJointSetFeedback(joint, &contact.impulse->joint);
      }
    }
  }
}

void Islands::choose_solvers(OdeTakes takes) {
  crowd_.clear();
  used_trains_ = 0;
  trains_in_.assign(members_.size(), {});
  for (std::size_t i = 0; i < members_.size(); ++i) {
    if (members_[i].size <= kMostForOde) continue;
    Trains& trains = trains_in_[sets_.first(i)];
    ++trains.count;
    trains.segments += members_[i].segments;
  }
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const std::size_t island = sets_.first(i);
    if (takes == OdeTakes::small_islands && sets_.size(i) <= kMostForOde) continue;
    if (island != i) {
      members_[i].crowd = members_[island].crowd;
      continue;
    }
    const Trains& trains = trains_in_[i];
    const bool are_trains = 2 * trains.segments >= sets_.size(i) && trains.count <= kMostEntangled;
    members_[i].crowd = are_trains ? &next_train() : &crowd_;
  }
}

Crowd& Islands::next_train() {
  if (used_trains_ == trains_.size()) trains_.emplace_back(physics_);
  Crowd& train = trains_[used_trains_++];
  train.clear();
  return train;
}

void Islands::step_others(base::ThreadPool& pool) {
  crowd_.step(Crowd::Method::sweeps);
  pool.divide(used_trains_, 1, [this](const base::ThreadPool::Share& share) {
    prepare_ode();
    for (std::size_t i = share.first; i < share.end; ++i) trains_[i].step(Crowd::Method::newton);
  });
}

void Islands::take_out(Member& member, std::span<const OdeRobot> robots) {
  if (member.robot) {
    member.crowd->add_robot(robots[*member.robot]);
  } else {
    for (const dBodyID body : member.bodies) member.crowd->add_obstacle(body);
  }
  for (const dBodyID body : member.bodies) dBodyDisable(body);
}

void Islands::dissolve(double softer) {
  dJointGroupEmpty(joints_.get());
  softer_ = softer;
  for (Member& member : members_) {
    if (!member.crowd) continue;
    member.crowd = nullptr;
    for (const dBodyID body : member.bodies) dBodyEnable(body);
  }
}

}  // namespace elsie::physics
