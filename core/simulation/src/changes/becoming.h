// What a running world needs in order to become another one.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/base/problems.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/simulation/run_result.h"
#include "elsie/world/attributes.h"
#include "elsie/world/description.h"

#include "changes/tuning.h"
#include "changes/undo.h"
#include "plugins/guard.h"
#include "plugins/statements.h"

namespace elsie::simulation {

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

  /// This object is new; it takes the place of another one if that had the same id.
  void note_new(const Component* object, const std::string& robot, const std::string& id,
                bool in_place_of_another) {
    new_.insert(object);
    if (in_place_of_another) {
      said_.notes.push_back({robot, id,
                             "it was made anew by an edit at " + time_ +
                                 " and has lost what it remembered of the run"});
    }
  }
  bool is_new(const Component* object) const { return new_.contains(object); }

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
  /// Whether an object that stands for `use`, and was made of this declaration, stays when it is
  /// described as `next`: it does if only parameters differ that an edit puts in place. It gets
  /// them when it is equipped again.
  bool keeps(Component& object, const Declaration& declaration, const world::PluginUse& use,
             const world::PluginUse& was, const world::PluginUse& next);
  bool is_tuned(const Component* object) const { return tuned_.contains(object); }

  /// From here on, objects of one robot are equipped again. Returns how that is undone once all
  /// that they look at is as it was.
  using Actions = std::vector<std::function<void()>>;
  std::shared_ptr<const Actions> begin_robot() { return again_ = std::make_shared<Actions>(); }
  /// Equips an object that stays, and sets parameters that differ; it keeps what it remembers.
  /// `find` finds it, with the members that it has then.
  void equip_again(const std::function<TunedObject()>& find, const Perception& example);

 private:
  const plugin::Host& host_;
  std::uint64_t seed_;
  std::string time_;
  Undo undo_;
  std::vector<base::Problem> problems_;
  Statements said_;
  std::set<const Component*> new_;
  std::set<std::pair<std::string, std::string>> asked_;  // of robots
  std::set<const world::PluginUse*> asked_uses_;
  struct Tuned {
    Setup before, now;
  };
  std::map<const Component*, Tuned> tuned_;
  std::shared_ptr<Actions> again_;
};

}  // namespace elsie::simulation
