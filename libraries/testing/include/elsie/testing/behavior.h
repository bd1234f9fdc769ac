// A behaviour under test.
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

/// The behaviours inside of a behaviour, with one answer.
class Inside final : public Coordination {
 public:
  Response answer;
  int asked = 0;

  Response respond(const Perception& now) override;
  void rate(std::span<const Motion> candidates, std::span<double> desirability) override;
  CommandSets command_sets() override;
};

///   Behavior shy("shy", {{"comfort", 0.4}});
///   shy.respond(Situation().beam(0, 0.1)).command
///
/// Any behaviour by its name. The first respond() calls equipped() and reset(), as before a run.
class Behavior {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  explicit Behavior(const std::string& name, const Settings& settings = {},
                    const Elements& elements = {});
  Behavior(const Plugins& plugins, const std::string& name, const Settings& settings = {},
           const Elements& elements = {});

  /// Its answer now. Names of events belong to the plugin: they are valid as long as this object.
  /// Throws what the plugin throws.
  Response respond(const Situation& now);
  /// Its answers to several instants in order.
  std::vector<Response> respond(const Sequence& sequence);

  /// Returns to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// Acts as when its library is replaced while a robot drives (docs/hot-reload.md): continues the
  /// run of `before`, with what that remembers and its random stream. Returns whether both classes
  /// derive from Remembers; otherwise nothing is remembered. Throws what the plugin throws.
  bool take_over(Behavior& before);
  /// Sets what the robot has; by default the first situation sets it. Throws what the plugin
  /// refuses.
  void equip(const Situation& example);
  /// Changes parameters as a user does during a run: calls configured() and equipped() again.
  void set(const Settings& settings);

  /// The behaviours inside of this one.
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
