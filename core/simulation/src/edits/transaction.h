// The state of an edit that turns a running world into a new one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/problems.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/attributes.h"
#include "elsie/world/description.h"

#include "edits/undo.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

/// The index of the element with this id; the size when there is none. Looks from `near` on, where
/// an edit of one element has left most others.
template <class Elements>
std::size_t index_of(const Elements& elements, const std::string& id, std::size_t near) {
  const auto is_it = [&](const auto& element) { return element.id == id; };
  const auto middle =
      elements.begin() + static_cast<std::ptrdiff_t>(std::min(near, elements.size()));
  auto at = std::find_if(middle, elements.end(), is_it);
  if (at == elements.end()) {
    at = std::find_if(elements.begin(), middle, is_it);
    if (at == middle) return elements.size();
  }
  return static_cast<std::size_t>(at - elements.begin());
}

/// An edit in progress: its new objects, its problems, and how to undo it.
class EditTransaction {
 public:
  EditTransaction(const plugin::Host& host, std::uint64_t seed, double time_s)
      : host_(host), seed_(seed), time_(base::seconds_text(time_s)) {}

  const plugin::Host& host() const { return host_; }
  std::uint64_t seed() const { return seed_; }
  /// The time of the edit: "2.5 s".
  const std::string& time() const { return time_; }
  Undo& undo() { return undo_; }
  /// Sets what settle() does besides.
  void settling(std::function<void()> action) { settling_ = std::move(action); }
  /// Keeps the edit.
  void settle() {
    undo_.settle();
    again_.settle();
    if (settling_) settling_();
  }
  std::vector<base::Problem>& problems() { return problems_; }
  Statements& said() { return said_; }

  /// Whether the physics may have something new to warn of: it looks at bodies and speeds.
  bool may_cause_warnings = false;
  std::vector<physics::Body> placed;  // bodies that are put elsewhere

  /// Notes that a new object replaces the one with this id.
  void note_lost(const std::string& robot, const std::string& id) {
    said_.notes.push_back(
        {robot, id, "an edit at " + time_ + " replaced it, and it lost its memory of the run"});
  }

  /// Notes that an edit sets this value, even if the description already has it.
  void ask(const world::AttributeTarget& target) {
    if (target.robot && !target.use) asked_.insert({target.robot->id, target.field.name});
  }
  void ask(const world::Obstacle& box, const std::string& attribute) {
    asked_.insert({"/" + box.id, attribute});
  }
  bool asks(const world::Obstacle& box, const char* attribute) const {
    return asked_.contains({"/" + box.id, attribute});
  }
  bool asks(const world::Robot& robot, const char* attribute) const {
    return asked_.contains({robot.id, attribute});
  }
  /// Returns whether the object stays: `was` and `next` differ only in parameters that may change
  /// during a run. If it stays, `next` becomes its description, and it gets the new parameters when
  /// it is equipped again.
  bool keeps(PluginObject& object, const world::PluginUse& was, const world::PluginUse& next);
  void describe(PluginObject& object, const world::PluginUse& next) {
    undo_.keep(object.use);
    object.use = &next;
  }
  /// Notes that the object must be equipped again.
  void note_other_equipment(const PluginObject& object) { again_with_.try_emplace(&object); }
  /// Returns whether the object itself must be equipped again.
  bool has_other(const PluginObject& object) const { return again_with_.contains(&object); }

  /// Equips an object that stays and sets the parameters that differ; it keeps its memory.
  void equip_again(PluginObject& object, const Example& example);

 private:
  const plugin::Host& host_;
  std::uint64_t seed_;
  std::string time_;
  Undo again_;  // equips again what stays, which looks at what undo_ restores before
  Undo undo_;
  std::function<void()> settling_;
  std::vector<base::Problem> problems_;
  Statements said_;
  std::set<std::pair<std::string, std::string>> asked_;  // of robots, of "/" and boxes
  struct Tuned {                                         // none: the parameters do not change
    std::optional<Setup> before, now;
  };
  std::map<const PluginObject*, Tuned> again_with_;
};

}  // namespace elsie::simulation
