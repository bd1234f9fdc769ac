// What an engine notes of robots only if somebody asks.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "elsie/physics/engine.h"

namespace elsie::physics {

/// Contacts of watched robots.
class ContactWatch {
 public:
  /// Names a contact within a step.
  using Key = std::array<std::uint64_t, 3>;

  void watch(std::size_t robot) {
    if (lists_.size() <= robot) lists_.resize(robot + 1);
    lists_[robot].is_watched = true;
    is_used_ = true;
  }
  bool watches(std::size_t robot) const {
    return robot < lists_.size() && lists_[robot].is_watched;
  }
  bool watches(const Body& body) const {
    return body.kind == BodyKind::robot && watches(body.index);
  }
  /// Whether any robot is watched.
  bool is_used() const { return is_used_; }

  void begin_step() {
    for (List& list : lists_) {
      list.keys.clear();
      list.contacts.clear();
    }
  }
  /// Impulses of one contact in several parts of the step add up; its place is the last one.
  void note(std::size_t robot, const Key& key, const BodyContact& contact) {
    auto& [is_watched, keys, contacts] = lists_[robot];
    const auto known = std::find(keys.begin(), keys.end(), key);
    if (known == keys.end()) {
      keys.push_back(key);
      contacts.push_back(contact);
      return;
    }
    BodyContact& same = contacts[static_cast<std::size_t>(known - keys.begin())];
    const Vector3 before = same.impulse;
    same = contact;
    same.impulse = before + contact.impulse;
  }
  void end_step() {
    const auto rank = [](const BodyContact& each) {
      const auto& [x, y, z] = each.point;
      return std::tuple(each.vehicle, each.other, x, y, z);
    };
    for (List& list : lists_) {
      std::sort(list.contacts.begin(), list.contacts.end(),
                [&](const BodyContact& a, const BodyContact& b) { return rank(a) < rank(b); });
    }
  }

  std::span<const BodyContact> of(std::size_t robot) const {
    return robot < lists_.size() ? std::span<const BodyContact>(lists_[robot].contacts)
                                 : std::span<const BodyContact>();
  }

 private:
  struct List {
    bool is_watched = false;
    std::vector<Key> keys;
    std::vector<BodyContact> contacts;
  };
  std::vector<List> lists_;  // of robots
  bool is_used_ = false;
};

}  // namespace elsie::physics
