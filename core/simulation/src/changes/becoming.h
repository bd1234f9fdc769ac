// What a running world needs in order to become another one.
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
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/attributes.h"
#include "elsie/world/description.h"

#include "changes/undo.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

/// The place of the one with this id; that of the end when there is none.
template <class Things>
std::size_t place_of(const Things& things, const std::string& id) {
  const auto at =
      std::find_if(things.begin(), things.end(), [&](const auto& thing) { return thing.id == id; });
  return static_cast<std::size_t>(at - things.begin());
}

/// One edit on its way: what it has made, what is wrong with it, and how to undo it.
class Becoming {
 public:
  Becoming(const plugin::Host& host, std::uint64_t seed, double time_s)
      : host_(host), seed_(seed), time_(base::seconds_text(time_s)) {}

  const plugin::Host& host() const { return host_; }
  std::uint64_t seed() const { return seed_; }
  /// When it is made: "2.5 s".
  const std::string& time() const { return time_; }
  Undo& undo() { return undo_; }
  std::vector<base::Problem>& problems() { return problems_; }
  Statements& said() { return said_; }

  /// A new object takes the place of the one of this id.
  void note_lost(const std::string& robot, const std::string& id) {
    said_.notes.push_back({robot, id,
                           "it was made anew by an edit at " + time_ +
                               " and has lost what it remembered of the run"});
  }

  /// An edit asks for this value, even if it is described already.
  void ask(const world::AttributePlace& place) {
    if (place.use) {
      asked_uses_.insert(place.use);
    } else if (place.robot) {
      asked_.insert({place.robot->id, place.field.name});
    }
  }
  bool asks(const world::Robot& robot, const char* attribute) const {
    return asked_.contains({robot.id, attribute});
  }
  /// Returns whether the object stays: `was` and `next` differ only in parameters that an edit puts
  /// in place. If it stays, `next` becomes its description, and it gets the new parameters when it
  /// is equipped again.
  bool keeps(PluginObject& object, const world::PluginUse& was, const world::PluginUse& next);
  /// Makes `next` its description and drops the parameters set since.
  void describe(PluginObject& object, const world::PluginUse& next);
  /// Notes that the object must be equipped again.
  void note_other_equipment(const PluginObject& object) { again_with_.try_emplace(&object); }
  /// Returns whether the object itself must be equipped again.
  bool has_other(const PluginObject& object) const { return again_with_.contains(&object); }

  /// From here on, objects of one robot are equipped again. Returns how that is undone once all
  /// that they look at is as it was.
  using Actions = std::vector<std::function<void()>>;
  std::shared_ptr<const Actions> begin_robot() { return again_ = std::make_shared<Actions>(); }
  /// Equips an object that stays, and sets parameters that differ; it keeps what it remembers.
  void equip_again(PluginObject& object, const Perception& example);

 private:
  const plugin::Host& host_;
  std::uint64_t seed_;
  std::string time_;
  Undo undo_;
  std::vector<base::Problem> problems_;
  Statements said_;
  std::set<std::pair<std::string, std::string>> asked_;  // of robots
  std::set<const world::PluginUse*> asked_uses_;
  struct Tuned {  // none: its parameters are the same
    std::optional<Setup> before, now;
  };
  std::map<const PluginObject*, Tuned> again_with_;
  std::shared_ptr<Actions> again_;
};

}  // namespace elsie::simulation
