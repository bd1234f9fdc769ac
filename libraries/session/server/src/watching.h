// The state of a run that a window watches, besides the positions of bodies.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "elsie/simulation/simulation.h"

#include "link.h"

namespace elsie::server {

class Watching {
 public:
  /// Reads an order: `what` and `robots`. Throws base::BadInput.
  void choose(const Json& order);
  /// Whether events `state` are wished.
  bool is_on() const { return what_.size() > (watches("stuck") ? 1 : 0); }
  bool watches(const char* what) const { return what_.contains(what); }

  /// The event `state`. Does not change the simulation. Throws simulation::PluginFault.
  Json state(const simulation::Simulation& simulation, std::uint64_t epoch) const;
  /// Of what is watched, what is no number: for each robot the pictures of its cameras, the
  /// messages that it heard, and the reasons of its behaviours, as in a state. Null if none of it
  /// is watched.
  Json look(const simulation::Simulation& simulation) const;

 private:
  bool shows(const simulation::Simulation& simulation, std::size_t index) const;
  Json robot(const simulation::Simulation& simulation, std::size_t index) const;

  std::set<std::string, std::less<>> what_;
  std::set<std::string, std::less<>> robots_;  // none: all
};

/// The present values of the measures, by name.
Json measures_json(std::span<const simulation::MeasuredValue> measures);

/// A note as `elsie run` prints it: "r1, wander: ...".
std::string text_of(const simulation::Note& note);

}  // namespace elsie::server
