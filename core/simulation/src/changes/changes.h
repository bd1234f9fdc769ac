// What a user changes while a world runs: checked first, then made as a whole.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/change.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/attributes.h"
#include "elsie/world/description.h"

#include "step/cameras.h"
#include "step/carrier.h"

namespace elsie::simulation {

/// Changes that are to be made together, before a step.
struct DueChanges {
  double time_s = 0.0;  // as it was asked for
  std::vector<Change> changes;
  std::string from{};   // TimedChange::from of the first that has one
  std::string given{};  // the first that the user gave

  /// Whether a step that begins now comes after them.
  bool are_due(double now_s, double step_s) const { return now_s >= time_s - kRounding * step_s; }
  /// Whether a run that ends then has such a step.
  bool come_before(double end_s, double step_s) const;
  static constexpr double kRounding = 1e-6;  // of a step: 0.57 is not a little after 57 of 0.01 s
};

/// One that stands in the world.
TimedChange timed(const world::TimedEdit& edit);

/// Those of the world, then the others.
std::vector<TimedChange> with_own(const world::World& world, std::span<const TimedChange> changes);

/// The same without those that are made by this time.
std::vector<TimedChange> still_to_come(const world::World& world,
                                       std::span<const TimedChange> changes, double after_s);

/// In the order of their times; those of one time in the order given.
std::vector<DueChanges> by_time(std::span<const TimedChange> changes);

class Changes {
 public:
  /// The run at this instant.
  struct Stage {
    Robots robots;
    physics::Engine& engine;
    const Cameras& cameras;
    double time_s;
  };

  /// Both stay where they are as long as this lives. Data files that a change names are looked for
  /// as the options say.
  Changes(const world::World& world, const plugin::Host& host, const Options& options);

  /// Returns whether the change needs no new world: it is made in place or refused.
  bool is_live(const Change& change) const;
  /// The attributes that it sets; none if it edits an element, or if there are none.
  std::vector<world::AttributePlace> places(const Change& change) const;

  /// Makes all of them, or throws ChangeRefused and makes none. Adds an event for each attribute.
  void make(std::span<const Change> changes, const Stage& stage,
            std::vector<EventRecord>& events) const;

  /// Those that could not be made, as far as that does not depend on what the run brings: only
  /// whether there is room for a robot does.
  std::vector<ChangeRefused> refused(std::span<const DueChanges> schedule,
                                     const Stage& stage) const;

 private:
  const world::World& world_;
  world::Attributes attributes_;
};

}  // namespace elsie::simulation
