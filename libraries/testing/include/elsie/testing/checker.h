// What every plugin must be: checked by trying.
//
//   for (const std::string& finding : check_plugin(PluginKind::behavior, "shy")) { ... }
//
// The declaration: meanings of the plugin, its parameters, elements and events; a unit for every
// number, or a bound at least for a pure one; a unit that fits a
// name's ending (speed_m_s is in m/s); sound ranges, defaults that are allowed and that objects
// really start with.
//
// Its objects, on random but possible input, with the given parameters and with random ones within
// their ranges (which configured() and equipped() may refuse, with a sentence):
// - answers are finite and in their ranges, events declared, nothing is thrown; the values of a
//   measure stay what it says that they are;
// - two objects answer the same input alike, also while a third one works on something else, and
//   the first again after reset() and after configured() was called once more: none shares state
//   with others, and none depends on a clock, on an address, or on random numbers other than its
//   own;
// - an object that takes over in mid-run what another one remembers (elsie/api/remember.h) goes on
// as
//   that would have, where the class offers it;
// - memory does not grow with the number of steps, and objects leave none behind.
//
// What no trial finds: a plugin that looks at a clock of whole seconds, or goes wrong on one input
// in a million.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "elsie/testing/plugins.h"
#include "elsie/testing/scene.h"
#include "elsie/testing/situation.h"

namespace elsie::testing {

struct CheckOptions {
  /// Parameters that are always set so: required ones, for example.
  Settings settings{};
  Elements elements{};
  /// The behaviours of a coordinator that takes no others; else random ones.
  std::vector<std::string> members{};
  /// The robot to be tried: its sensors, body and team. Values are random all the same. Else
  /// several, with beams, switches, cameras, and a sensor for each kind of reading that the plugin
  /// needs.
  std::vector<Situation> robots{};
  /// The worlds to be tried, for a measure: their robots, behaviours and boxes. What happens there
  /// is random all the same. Else several, with robots r1, r2... of the teams red and blue.
  std::vector<Scene> scenes{};
  /// Puts in readings of kinds that no sensor plugin makes.
  std::function<void(Situation&, Random&)> add_readings{};
  std::uint64_t seed = 1;
  /// How many sets of random parameters.
  int variants = 20;
  /// Steps for the look at memory, which must not grow: a run goes on for a few times as many when
  /// it seems to.
  int steps = 20000;
  /// A plugin that comes to hold more than this is a finding, and is not tried any further; bytes.
  std::size_t memory_limit = 1'000'000'000;
};

/// What is wrong with a plugin, each a sentence that names it; empty when nothing was found. Throws
/// plugin::PluginError when there is no such plugin.
std::vector<std::string> check_plugin(PluginKind kind, const std::string& name,
                                      const CheckOptions& options = {},
                                      const Plugins& plugins = Plugins::found());

/// The part about the declaration alone.
std::vector<std::string> check_declaration(const Declaration& declaration);

}  // namespace elsie::testing
