#include "routing.h"

#include <cstdint>
#include <utility>

namespace elsie::physics {
namespace {

// ODE's solver takes islands up to this size: six robots. A segment or a box has about half as many
// equations as a robot.
constexpr std::size_t kRobotSize = 2;
constexpr std::size_t kMostForOde = 6 * kRobotSize;

std::size_t member_of(void* data) { return reinterpret_cast<std::uintptr_t>(data) - 1; }

}  // namespace

void Routing::add_robot(const OdeRobot& robot) {
  Member member;
  member.robot = robots_++;
  member.size = kRobotSize + robot.vehicles().size() - 1;
  robot.for_each_body([&](dBodyID body) { member.bodies.push_back(body); });
  add(std::move(member));
}

void Routing::add_box(dBodyID box) {
  Member member;
  member.bodies.push_back(box);
  add(std::move(member));
}

void Routing::add(Member member) {
  members_.push_back(std::move(member));
  // Numbers start at 1, because an ODE body without data has 0.
  const auto number = static_cast<std::uintptr_t>(members_.size());
  for (const dBodyID body : members_.back().bodies) {
    dBodySetData(body, reinterpret_cast<void*>(number));
  }
}

void Routing::remove_box(dBodyID box) { members_[member_of(dBodyGetData(box))].bodies.clear(); }

void Routing::divide(std::span<FoundContacts> found, ContactJoints& joints,
                     std::span<const OdeRobot> robots, OdeTakes takes) {
  islands_.reset(members_.size());
  for (std::size_t i = 0; i < members_.size(); ++i) islands_.count(i, members_[i].size);
  for (FoundContacts& some : found) {
    for (const FoundContact& contact : some.contacts.found()) {
      if (contact.a && contact.b) {
        islands_.link(member_of(contact.member_a), member_of(contact.member_b));
      }
    }
  }
  crowd_.clear();
  for (std::size_t i = 0; i < members_.size(); ++i) {
    // A member without contacts is small, however many segments it pulls.
    const bool small = islands_.members(i) == 1 || islands_.size(i) <= kMostForOde;
    if (takes == OdeTakes::nothing || !small) take_out(members_[i], robots);
  }
  std::size_t number = 0;
  for (FoundContacts& some : found) {
    for (FoundContact& contact : some.contacts.found()) {
      joints.finish(contact, number++);
      if (members_[member_of(contact.a ? contact.member_a : contact.member_b)].in_crowd) {
        crowd_.add_contact(contact);
      } else {
        joints.join(contact);
      }
    }
  }
}

void Routing::take_out(Member& member, std::span<const OdeRobot> robots) {
  member.in_crowd = true;
  if (member.robot) {
    crowd_.add_robot(robots[*member.robot]);
  } else {
    for (const dBodyID body : member.bodies) crowd_.add_box(body);
  }
  for (const dBodyID body : member.bodies) dBodyDisable(body);
}

void Routing::wake() {
  for (Member& member : members_) {
    if (!member.in_crowd) continue;
    member.in_crowd = false;
    for (const dBodyID body : member.bodies) dBodyEnable(body);
  }
}

}  // namespace elsie::physics
