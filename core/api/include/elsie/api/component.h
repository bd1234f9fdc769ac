// The base of all plugin objects.
#pragma once

#include <string>
#include <vector>

#include "elsie/api/curve.h"
#include "elsie/api/sketch.h"
#include "elsie/base/random.h"

namespace elsie {

/// A sensor, actuator, behaviour, coordinator, measure, rule, drive or localisation at run time.
/// Its life:
///
///   constructed -> parameters and nested elements set -> configured() -> equipped()
///     -> { reset() -> notes(), curves() -> many steps }... -> destroyed
///
/// It belongs to one robot (a measure or rule: to the world); instances share nothing. One thread
/// at a time calls it, not always the same one. The simulator catches every exception, names the
/// plugin, the robot and the step, and ends the run in an orderly way.
class Component {
 public:
  Component() = default;
  Component(const Component&) = delete;
  Component& operator=(const Component&) = delete;
  virtual ~Component() = default;

  /// Called after the parameters were set, and again whenever one was changed, also during a run.
  /// Check here what single ranges cannot express, read files, build tables. Throw
  /// (std::invalid_argument, with a sentence) when the parameters do not fit together. The
  /// simulator tries a change on another object first, so this object only gets changes that fit.
  /// Keep what the object remembers of the run; reset() forgets it. A parameter that only takes
  /// effect before a run says so in its declaration (ParameterFacts::live).
  virtual void configured() {}

  /// Called before each run: forget the state of the last run. `random` is the object's own stream,
  /// at its start; the object draws from the same stream during the run.
  virtual void reset(Random& /*random*/) {}

  /// Sentences for the user after a run is prepared: how well a network was trained, what was left
  /// out. Called after reset().
  virtual std::vector<std::string> notes() const { return {}; }

  /// Curves for the user: the learning curve of a network that was trained for this run, after
  /// reset(); of a measure what it saw, at the end of the run. They may have any length; a few
  /// hundred points are enough. Names must differ.
  virtual std::vector<Curve> curves() const { return {}; }

  /// Draws what it senses, thinks or wants at this instant. Called only when somebody looks,
  /// between two steps: a run is the same with and without it.
  virtual void sketch(Sketch& /*sketch*/) const {}
};

}  // namespace elsie
