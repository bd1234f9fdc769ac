// What all plugin objects have in common.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/curve.h"
#include "elsie/base/random.h"

namespace elsie {

/// A sensor, behaviour, coordinator, measure or drive at run time. Life of one:
///
///   constructed -> parameters and nested elements set -> configured() -> equipped()
///     -> { reset() -> notes(), curves() -> many steps }... -> destroyed
///
/// It belongs to one robot (a measure: to the world); instances share nothing. It is called from
/// one thread at a time, perhaps not always the same one. Exceptions thrown anywhere are caught by
/// the simulator, which names the plugin, the robot and the step, and ends the run in an orderly
/// way.
class Component {
 public:
  Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component() = default;

  /// Called after the parameters were set, and again whenever one was changed, also while a run
  /// goes on. Check here what no single range can say, read files, build tables. Throw
  /// (std::invalid_argument, with a sentence) when the parameters do not fit together. A change is
  /// tried on another object first, so that this one hears only of those that fit. What the object
  /// remembers of the run should last: forgetting is for reset(). A parameter that only means
  /// something before a run says so in its declaration (ParameterFacts::live).
  virtual void configured() {}

  /// Called before each run: forget what the last run left. `random` is the object's own stream,
  /// at its start: the one that it draws from during the run.
  virtual void reset(Random& /*random*/) {}

  /// Sentences for the user, once a run is prepared: how well a network was
  /// trained, what was left out. Asked after reset().
  virtual std::vector<std::string> notes() const { return {}; }

  /// What a user may want to see drawn, likewise: the learning curve of a network that was trained
  /// for this run. A few hundred points say enough. Each by another name.
  virtual std::vector<Curve> curves() const { return {}; }
};

}  // namespace elsie
