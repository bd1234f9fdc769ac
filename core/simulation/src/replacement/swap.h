// Replaces old plugin objects by new ones.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "elsie/plugin/call.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/replacement.h"

#include "edits/undo.h"
#include "plugins/guard.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

/// All exchanges of one replacement. The destructor undoes them unless settle() was called.
class Swap {
 public:
  /// `host` makes the new objects. Files that are defaults of new parameters are searched for in
  /// `data_directories`.
  Swap(const plugin::Host& host, std::uint64_t seed, std::vector<std::string> data_directories)
      : host_(host), seed_(seed), data_directories_(std::move(data_directories)) {}

  /// Further actions for the case that this is not settled.
  Undo& undo() { return undo_; }

  /// Sets the robot of the next exchanges.
  void begin_robot(const std::string& id) {
    robot_ = id;
    first_ = exchanged_.size();
    staying_.clear();
  }
  /// Returns whether this robot has a new object.
  bool concerns_robot() const { return exchanged_.size() > first_; }

  /// Replaces the object if its plugin has changed; returns whether it did. The new object gets the
  /// old parameters that it still declares; the world's description drops the others, too. Throws
  /// ReplacementRefused.
  bool exchange(PluginObject& object, const std::string& path);

  /// Notes that this object of the robot stays and could see a difference: it is equipped again.
  void stays(PluginObject& object, const std::string& path) { staying_.push_back({&object, path}); }

  /// The world with the parameters that the plugins of the new host still declare.
  world::World adapted(world::World world) const;

  /// Runs code of an object; its exceptions become a ReplacementRefused.
  template <class Action>
  void run(const PluginObject& object, const std::string& path, Action action) const {
    const plugin::Call call({.plugin = &object.use->plugin,
                             .id = &object.use->id,
                             .robot = &robot_,
                             .doing = "while plugins were replaced"});
    try {
      action();
    } catch (...) {
      refuse(path, base::what_was_thrown());
    }
  }

  /// Equips and resets the robot's new objects, and gives them the memory of the old ones; equips
  /// again what stays.
  void hand_over(const Example& example);

  /// Keeps the exchanges and destroys the old objects. Returns the exchanges.
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
  std::size_t first_ = 0;             // index of this robot's first exchange
  std::vector<Exchanged> exchanged_;  // one for each of replacement_.objects
  Replacement replacement_;
  std::vector<std::pair<PluginObject*, std::string>> staying_;  // with their paths
  Undo again_;  // equips again what stays, which looks at what undo_ restores before
  Undo undo_;
};

}  // namespace elsie::simulation
