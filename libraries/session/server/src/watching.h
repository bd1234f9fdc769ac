// What a window watches: the state of a run beyond where everything is.
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
  /// From an order: `what` and `robots`. Throws base::BadInput.
  void choose(const Json& order);
  bool is_on() const { return !what_.empty(); }

  /// The event. It only looks at the simulation. Throws simulation::PluginFault.
  Json state(const simulation::Simulation& simulation, std::uint64_t epoch) const;

 private:
  bool watches(const char* what) const { return what_.contains(what); }
  Json robot(const simulation::Simulation& simulation, std::size_t index) const;

  std::set<std::string, std::less<>> what_;
  std::set<std::string, std::less<>> robots_;  // none: all
};

/// The measures so far, by name.
Json measures_json(std::span<const simulation::MeasuredValue> measures);

/// "r1, wander: ...", as `elsie run` prints it.
std::string text_of(const simulation::Note& note);

}  // namespace elsie::server
