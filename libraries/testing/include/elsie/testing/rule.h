// A rule under test.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/rule.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/scene.h"

namespace elsie::testing {

/// What a rule answered to an instant.
struct Ruling {
  std::vector<std::string> edits;   // "robot[r1]/@energy=50"; a place() is three of them
  std::vector<std::string> events;  // "alarm" for all robots, "alarm of r1"
  RunEnd::Outcome outcome = RunEnd::Outcome::running;
  std::string reason;
};

///   Scene now;
///   now.robot("r1").resource("food", 1, 2);
///   Rule back("respawn", {{"after", 0.02}});
///   back.apply(now);
///   now.remove_obstacle("food");
///   CHECK(back.apply(now.step()).edits.empty());
///
/// Any rule by its name. The first apply() calls equipped() and reset(), as before a run. Scenes
/// stay as they are, whatever it edits.
class Rule {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  explicit Rule(const std::string& name, const Settings& settings = {},
                const Elements& elements = {});
  Rule(const Plugins& plugins, const std::string& name, const Settings& settings = {},
       const Elements& elements = {});

  /// Shows the rule an instant. Throws what the plugin throws, and std::invalid_argument for an
  /// event that its declaration does not name. The answer is valid until the next call.
  const Ruling& apply(const Scene& now);

  /// Answers WorldChanges::has_room(); by default there is room everywhere.
  std::function<bool(std::string_view what, const Pose& pose)> has_room;

  /// Returns to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// Sets what the world has; by default the first scene sets it. Throws what the plugin refuses.
  void equip(const Scene& start);

  const Declaration& declaration() const { return *declaration_; }
  elsie::Rule& operator*() { return *object_; }
  elsie::Rule* operator->() { return object_.get(); }

 private:
  Plugins plugins_;
  const Declaration* declaration_;
  plugin::Object<elsie::Rule> object_;
  Random random_;
  Ruling answer_;
  bool equipped_ = false;
  bool reset_ = false;
};

}  // namespace elsie::testing
