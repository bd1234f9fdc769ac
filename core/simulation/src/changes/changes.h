// Changes by a user during a run: first all are checked, then all are made.
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

/// Changes to make together before a step.
struct DueChanges {
  double time_s = 0.0;  // the time that was given
  std::vector<Change> changes;
  std::string from{};   // of the first change that has one
  std::string given{};  // the user's first change

  /// Returns whether they are due before a step that begins now.
  bool are_due(double now_s, double step_s) const { return now_s >= time_s - kRounding * step_s; }
  /// Returns whether a run with this end has such a step.
  bool come_before(double end_s, double step_s) const;
  static constexpr double kRounding = 1e-6;  // of a step: 57 steps of 0.01 s make 0.57 s
};

/// A change from World::changes.
TimedChange timed(const world::TimedEdit& edit);

/// The changes of the world, then the others.
std::vector<TimedChange> with_own(const world::World& world, std::span<const TimedChange> changes);

/// The same, without those that were made up to this time.
std::vector<TimedChange> still_to_come(const world::World& world,
                                       std::span<const TimedChange> changes, double after_s);

/// Sorts the changes by time; changes with the same time keep their order.
std::vector<DueChanges> by_time(std::span<const TimedChange> changes);

class Changes {
 public:
  /// The state of the run at this instant.
  struct Stage {
    Robots robots;
    physics::Engine& engine;
    const Cameras& cameras;
    double time_s;
  };

  /// The world and the host must outlive this object. The options say where to search for data
  /// files.
  Changes(const world::World& world, const plugin::Host& host, const Options& options);

  /// Returns whether the change is made in place (or refused), without a new world.
  bool is_live(const Change& change) const;
  /// The attributes that the change sets; none if it edits an element or matches none.
  std::vector<world::AttributePlace> places(const Change& change) const;
  /// The ids of the robots that the change leads to.
  std::vector<std::string> robots(const Change& change) const {
    return attributes_.robots_at(change.path);
  }

  /// To be called when the description of a robot has moved in memory.
  void renew_robot(std::size_t index) { attributes_.renew_robot(index); }

  /// A robot's new place.
  struct Placed {
    std::size_t robot = 0;
    Pose pose;
    double z = 0.0;    // m
    std::string text;  // of the changes, for messages
  };

  /// Checks all changes and sets the parameters of plugins, or throws ChangeRefused and changes
  /// nothing. Adds an event for each attribute. What is left to do: to describe() the changes, let
  /// the robots take what they then describe, and put robots in these places.
  std::vector<Placed> make(std::span<const Change> changes, const Stage& stage,
                           std::vector<EventRecord>& events) const;
  /// Sets the attributes in the world, which must be as world::Attributes::set() demands.
  void describe(std::span<const Change> changes) const;

  /// The changes that cannot be made, except for lack of room for a robot, which depends on the
  /// run.
  std::vector<ChangeRefused> refused(std::span<const DueChanges> schedule,
                                     const Stage& stage) const;

 private:
  const world::World& world_;
  world::Attributes attributes_;
};

}  // namespace elsie::simulation
