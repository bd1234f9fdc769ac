// New plugin objects in the places of old ones.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elsie/plugin/call.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/replacement.h"

#include "changes/undo.h"
#include "plugins/guard.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

/// All that is exchanged at one time. Undone by its destructor unless it was settled.
class Swap {
 public:
  /// `host`: where the new objects come from. Files that new parameters name by default are looked
  /// for in `data_directories`.
  Swap(const plugin::Host& host, std::uint64_t seed, std::vector<std::string> data_directories)
      : host_(host), seed_(seed), data_directories_(std::move(data_directories)) {}

  /// What else has to be put back when this is not settled.
  Undo& undo() { return undo_; }

  /// The robot that the next exchanges are about.
  void begin_robot(const std::string& id) {
    robot_ = id;
    first_ = exchanged_.size();
  }
  /// Whether it has a new object.
  bool concerns_robot() const { return exchanged_.size() > first_; }

  /// Puts a new object in the place of the one of this name if its plugin has changed; whether it
  /// did. The parameters are the old ones as far as there are such, in the world's description,
  /// too. Throws ReplacementRefused.
  bool exchange(PluginObject& object, const std::string& path);

  /// Runs code of an object that was exchanged; what it throws becomes a ReplacementRefused.
  template <class Action>
  void run(const PluginObject& object, const std::string& path, Action action) const {
    const plugin::Call call({.plugin = object.use->plugin.c_str(),
                             .id = object.use->id.c_str(),
                             .robot = robot_.c_str(),
                             .doing = "while it was put in the place of an older one"});
    try {
      action();
    } catch (...) {
      refuse(path, what_was_thrown());
    }
  }

  /// Equips the robot's new objects, resets them, and hands over what the old ones remember.
  void hand_over(const Perception& example);

  /// From here on nothing is undone, and the old objects go. Returns what was done.
  Replacement settle();

  [[noreturn]] void refuse(const std::string& path, const std::string& problem) const {
    throw ReplacementRefused("robot '" + robot_ + "', " + path + ": " + problem);
  }

 private:
  struct Exchanged {
    PluginObject* object;
    Component* before;
  };

  void fit(PluginObject& object, const std::string& path);

  const plugin::Host& host_;
  std::uint64_t seed_;
  std::vector<std::string> data_directories_;
  std::string robot_;
  std::size_t first_ = 0;             // exchanged on this robot
  std::vector<Exchanged> exchanged_;  // as many as replacement_ has objects
  Replacement replacement_;
  Undo undo_;
};

}  // namespace elsie::simulation
