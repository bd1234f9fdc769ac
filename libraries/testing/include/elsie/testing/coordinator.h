// A coordinator under test.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/testing/plugins.h"
#include "elsie/testing/sequence.h"
#include "elsie/testing/team.h"

namespace elsie::testing {

/// A member's command to an actuator.
struct Wish {
  template <class Command>
  Wish(std::string member_name, Command command)
      : member(std::move(member_name)), act("", std::move(command)) {}

  std::string member;
  Act act;
};

///   Coordinator vote("arbiter_voting", team);
///   CHECK_THAT(vote.decide(), commands_wheels(10, 10));
///   CHECK(team.trace("avoid").share == 1);
///
/// Any coordinator by its name, with its team, which must outlive it. The first decision calls
/// equipped() and reset(), as before a run.
class Coordinator {
 public:
  /// Throws plugin::PluginError with a sentence for an unknown plugin, wrong names or values of
  /// parameters, and what configured() refuses.
  Coordinator(const std::string& name, Team& team, const Settings& settings = {},
              const Elements& elements = {});
  Coordinator(const Plugins& plugins, const std::string& name, Team& team,
              const Settings& settings = {}, const Elements& elements = {});

  /// One decision on the team's present answers. Throws what the plugin throws.
  Motion decide();
  Motion decide(const Situation& situation);
  Motion decide_at(double time_s);
  /// Its decisions at several instants in order.
  std::vector<Motion> decide(const Sequence& sequence);

  /// Which command an actuator gets, after a decision: resolve("lamp", {{"avoid",
  /// LedCommand{kRed}},
  /// {"seek", LedCommand{kBlue}}}). An index into the wishes, or their number for none of them, as
  /// the plugin says it. Throws std::invalid_argument for a name that no member has.
  std::size_t resolve(const std::string& actuator, const std::vector<Wish>& wishes);

  /// Its ratings after a decision, as an outer coordinator would get them if this one were inside a
  /// behaviour.
  std::vector<double> rate(const std::vector<Motion>& candidates);
  CommandSets sets();

  /// Returns to the start of a run, with the random stream of this seed.
  void reset(std::uint64_t seed = 1);
  /// Acts as when its library is replaced while a robot drives (docs/hot-reload.md): continues the
  /// run of `before`, with what that remembers and its random stream. Returns whether both classes
  /// derive from Remembers; otherwise nothing is remembered. Throws what the plugin throws.
  bool take_over(Coordinator& before);
  /// Sets what the robot has; by default the first situation sets it. Throws what the plugin
  /// refuses.
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
  Motion given_;
  bool equipped_ = false;
  bool reset_ = false;
};

}  // namespace elsie::testing
