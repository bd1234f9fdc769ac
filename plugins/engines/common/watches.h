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

/// Accelerations of watched robots.
class MotionWatch {
 public:
  struct Velocity {
    Vector3 linear;   // m/s
    Vector3 turning;  // rad/s
  };

  void watch(std::size_t robot, std::size_t vehicles) {
    if (watches(robot)) return;
    if (places_.size() <= robot) places_.resize(robot + 1, kNone);
    places_[robot] = watched_.size();
    watched_.push_back({robot, std::vector<Vehicle>(vehicles)});
  }
  bool watches(std::size_t robot) const {
    return robot < places_.size() && places_[robot] != kNone;
  }
  /// Watches a robot if another engine watches it, and takes over its last step there.
  void take(std::size_t robot, const MotionWatch& other, std::size_t same, std::size_t vehicles) {
    if (!other.watches(same)) return;
    const std::vector<Vehicle>& known = other.watched_[other.places_[same]].vehicles;
    watch(robot, vehicles);
    std::copy_n(known.begin(), std::min(known.size(), vehicles),
                watched_[places_[robot]].vehicles.begin());
  }

  /// `velocity_of(robot, vehicle)`: of the vehicle's origin.
  template <class VelocityOf>
  void begin_step(VelocityOf velocity_of) {
    for (auto& [robot, vehicles] : watched_) {
      for (std::size_t i = 0; i < vehicles.size(); ++i) vehicles[i].before = velocity_of(robot, i);
    }
  }
  template <class VelocityOf>
  void end_step(double step, VelocityOf velocity_of) {
    for (auto& [robot, vehicles] : watched_) {
      for (std::size_t i = 0; i < vehicles.size(); ++i) {
        const auto& [linear, turning] = vehicles[i].before;
        const Velocity now = velocity_of(robot, i);
        vehicles[i].change = {(1.0 / step) * (now.linear - linear),
                              (1.0 / step) * (now.turning - turning)};
      }
    }
  }

  Motion motion(std::size_t robot, std::size_t vehicle, const Velocity& now) const {
    Motion motion{now.linear, now.turning, {}, {}};
    if (watches(robot)) {
      const Velocity& change = watched_[places_[robot]].vehicles[vehicle].change;
      motion.acceleration = change.linear;
      motion.turning_acceleration = change.turning;
    }
    return motion;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  struct Vehicle {
    Velocity before;  // at the beginning of the step
    Velocity change;  // m/s2 and rad/s2
  };
  struct Watched {
    std::size_t robot = 0;
    std::vector<Vehicle> vehicles;
  };
  std::vector<std::size_t> places_;  // of robots, in watched_
  std::vector<Watched> watched_;
};

}  // namespace elsie::physics
