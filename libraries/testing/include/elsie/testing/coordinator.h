// A coordinator, ready to decide.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/sequence.h"
#include "elsie/testing/team.h"

namespace elsie::testing {

///   Coordinator vote("arbiter_voting", team);
///   CHECK(vote.decide().left == 10);
///   CHECK(team.trace("avoid").share == 1);
///
/// Any coordinator by its name, with its team, which must outlive it. On the first decision it is
/// told what the robot has (equipped()) and reset, as before a run.
class Coordinator {
 public:
  /// Throws plugin::PluginError, with a sentence: no such plugin, wrong names and values of
  /// parameters, what configured() refuses.
  Coordinator(const std::string& name, Team& team, const Settings& settings = {},
              const Elements& elements = {});
  Coordinator(const Plugins& plugins, const std::string& name, Team& team,
              const Settings& settings = {}, const Elements& elements = {});

  /// One decision, on what is in `now`. Throws what the plugin throws.
  MotorCommand decide();
  MotorCommand decide(const Situation& situation);
  MotorCommand decide_at(double time_s);
  /// Its decisions at one instant after the other.
  std::vector<MotorCommand> decide(const Sequence& sequence);

  /// What an outer coordinator would hear after a decision, if this one were inside a behaviour.
  std::vector<double> rate(const std::vector<MotorCommand>& candidates);
  CommandSets sets();

  /// Back to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// As when its library is replaced while a robot drives (docs/hot-reload.md): from the start of
  /// the run in which `before` is, with what that remembers, its random stream going on. Whether
  /// both classes derive from Remembers; otherwise nothing is remembered. Throws what the plugin
  /// throws.
  bool take_over(Coordinator& before);
  /// What the robot has; else the first situation says it. Throws what the plugin refuses.
  void equip(const Situation& example);

  const Declaration& declaration() const { return *declaration_; }
  elsie::Coordinator& operator*() { return *object_; }
  elsie::Coordinator* operator->() { return object_.get(); }

  Situation now;

 private:
  Plugins plugins_;
  const Declaration* declaration_;
  Team& team_;
  std::uint64_t seed_ = 1;  // of the random stream
  Random random_;
  plugin::Object<elsie::Coordinator> object_;
  MotorCommand given_;
  bool equipped_ = false;
  bool reset_ = false;
};

}  // namespace elsie::testing
