// Checks what every plugin must satisfy, by trying it.
//
//   for (const std::string& finding : check_plugin(PluginKind::behavior, "shy")) { ... }
//
// The declaration: meanings of the plugin, its parameters, elements and events; for every number a
// unit, or at least a bound; a unit that fits the end of a name (speed_m_s is in m/s); sound
// ranges; defaults that are allowed and that new objects have.
//
// Its objects, on random but possible input, with the given parameters and with random ones within
// their ranges (which configured() and equipped() may refuse with a sentence):
// - answers are finite and within their ranges, events and commands of actuators are declared,
//   nothing is thrown; the values of a measure are always those that it names;
// - two objects answer the same input alike, also while a third one works on other input, and the
//   first again after reset() and after a second configured(): objects share no state, and depend
//   on no clock, no address, and no random numbers but their own;
// - an object answers alike while another sensor, behaviour or coordinator of its library works on
//   another robot: what one leaves in a static, no other reads;
// - objects of two robots answer alike in two threads at once and one after the other, unless the
//   plugin declares one_thread(); a fault that shows in few runs is found for sure only with the
//   thread sanitizer (-fsanitize=thread);
// - an object that takes over in mid-run what another one remembers (elsie/api/remember.h)
//   continues as the other would have, if the class offers it;
// - memory does not grow with the number of steps, and destroyed objects leave none behind.
//
// No trial finds a plugin that reads a clock of whole seconds, or that fails on one input in a
// million.
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
  /// Parameters with fixed values: required ones, for example.
  Settings settings{};
  Elements elements{};
  /// The behaviours of a coordinator that accepts no others; by default random ones.
  std::vector<std::string> members{};
  /// The robots to try: their sensors, body and team; values remain random. By default several,
  /// with beams, switches, cameras, and a sensor for each kind of reading that the plugin needs.
  std::vector<Situation> robots{};
  /// The worlds to try for a measure: their robots, behaviours and boxes; events in them remain
  /// random. By default several, with robots r1, r2... of the teams red and blue.
  std::vector<Scene> scenes{};
  /// Adds readings of kinds that no sensor plugin makes.
  std::function<void(Situation&, Random&)> add_readings{};
  std::uint64_t seed = 1;
  /// The number of sets of random parameters.
  int variants = 20;
  /// The number of steps in which memory must not grow; if it seems to, the run continues for
  /// several times as many.
  int steps = 20000;
  /// The memory limit of a plugin in bytes. Beyond it, the trial ends with a finding.
  std::size_t memory_limit = 1'000'000'000;
};

/// The faults of a plugin as sentences that name it; empty if there are none. Throws
/// plugin::PluginError when there is no such plugin.
std::vector<std::string> check_plugin(PluginKind kind, const std::string& name,
                                      const CheckOptions& options = {},
                                      const Plugins& plugins = Plugins::found());

/// The checks of the declaration alone.
std::vector<std::string> check_declaration(const Declaration& declaration);

}  // namespace elsie::testing
