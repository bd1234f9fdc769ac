// A behaviour, ready to be asked.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/sequence.h"
#include "elsie/testing/situation.h"

namespace elsie::testing {

/// Behaviours inside a behaviour that holds some, with one answer.
class Inside final : public Coordination {
 public:
  Response answer;
  int asked = 0;

  Response respond(const Perception& now) override;
  void rate(std::span<const MotorCommand> candidates, std::span<double> desirability) override;
  CommandSets command_sets() override;
};

///   Behavior shy("shy", {{"comfort", 0.4}});
///   shy.respond(Situation().beam(0, 0.1)).command
///
/// Any behaviour by its name. On the first respond() it is told what the robot has (equipped()) and
/// reset, as before a run.
class Behavior {
 public:
  /// Throws plugin::PluginError, with a sentence: no such plugin, wrong names and values of
  /// parameters, what configured() refuses.
  explicit Behavior(const std::string& name, const Settings& settings = {},
                    const Elements& elements = {});
  Behavior(const Plugins& plugins, const std::string& name, const Settings& settings = {},
           const Elements& elements = {});

  /// What it answers now. The names of events are the plugin's: valid as long as this object.
  /// Throws what the plugin throws.
  Response respond(const Situation& now);
  /// Its answers to one instant after the other.
  std::vector<Response> respond(const Sequence& sequence);

  /// Back to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// As when its library is replaced while a robot drives (docs/hot-reload.md): from the start of
  /// the run in which `before` is, with what that remembers, its random stream going on. Whether
  /// both classes derive from Remembers; otherwise nothing is remembered. Throws what the plugin
  /// throws.
  bool take_over(Behavior& before);
  /// What the robot has; else the first situation says it. Throws what the plugin refuses.
  void equip(const Situation& example);
  /// Changes parameters, as a user does while it runs: configured() is called again, and
  /// equipped().
  void set(const Settings& settings);

  /// What a behaviour that holds others holds.
  Inside& inside() { return *inside_; }
  const Declaration& declaration() const { return *declaration_; }
  elsie::Behavior& operator*() { return *object_; }
  elsie::Behavior* operator->() { return object_.get(); }

 private:
  Plugins plugins_;
  const Declaration* declaration_;
  std::unique_ptr<Inside> inside_;
  std::uint64_t seed_ = 1;  // of the random stream
  Random random_;
  plugin::Object<elsie::Behavior> object_;
  std::optional<Situation> example_;  // what it was equipped with
  bool reset_ = false;
};

}  // namespace elsie::testing
