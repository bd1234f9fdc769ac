// Edits in place during a run: first all are checked, then all are made.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/edit.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/attributes.h"
#include "elsie/world/description.h"

#include "robot/robot_surroundings.h"
#include "step/cameras.h"

namespace elsie::simulation {

/// The index in World::obstacles if the attribute puts one of them elsewhere.
std::optional<std::size_t> placed_box(const world::World& world,
                                      const world::AttributeTarget& target);

/// Where an obstacle is described to be.
inline Pose pose_of(const world::Obstacle& box) {
  return {box.x, box.y, wrap_angle(radians(box.heading_deg))};
}
/// Where it is now; of a resource that was collected, where it was.
Pose pose_of_box(const physics::Engine& engine, const world::World& world, std::size_t index);

/// Edits to make together before a step.
struct DueEdits {
  double time_s = 0.0;  // the time that was given
  std::vector<Edit> edits;
  std::string from{};   // of the first edit that has one
  std::string given{};  // the user's first edit

  /// Returns whether they are due before a step that begins now.
  bool are_due(double now_s, double step_s) const { return now_s >= time_s - kRounding * step_s; }
  /// Returns whether a run with this end has such a step.
  bool come_before(double end_s, double step_s) const;
  static constexpr double kRounding = 1e-6;  // of a step: 57 steps of 0.01 s make 0.57 s
};

/// An edit from World::edits.
TimedEdit timed(const world::TimedEdit& edit);

/// The edits of the world, then the others.
std::vector<TimedEdit> with_own(const world::World& world, std::span<const TimedEdit> edits);

/// The same, without those that were made up to this time.
std::vector<TimedEdit> still_to_come(const world::World& world, std::span<const TimedEdit> edits,
                                     double after_s);

/// Sorts the edits by time; edits with the same time keep their order.
std::vector<DueEdits> by_time(std::span<const TimedEdit> edits);

class InPlaceEdits {
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
  InPlaceEdits(const world::World& world, const plugin::Host& host, const Options& options);

  /// Returns whether the edit is made in place (or refused), without a new world.
  bool is_live(const Edit& edit) const;
  /// The attributes that the edit sets; none if it edits an element or matches none.
  std::vector<world::AttributeTarget> targets(const Edit& edit) const;
  /// The ids of the robots that the edit leads to.
  std::vector<std::string> robots(const Edit& edit) const {
    return attributes_.robots_at(edit.path);
  }

  /// The tree of the world, which is made again when it is needed.
  std::unique_ptr<world::WorldTree> take_tree() { return attributes_.take_tree(); }
  /// To be called when the description of a robot has moved in memory.
  void renew_robot(std::size_t index) { attributes_.renew_robot(index); }

  /// The new place of a robot or an obstacle.
  struct Placed {
    physics::Body body;
    Pose pose;
    double z = 0.0;    // m, of a robot
    std::string text;  // of the edits, for messages
  };

  /// Checks all edits and sets the parameters of plugins, or throws EditRefused and changes
  /// nothing. Adds an event for each attribute. What is left to do: to describe() the edits, let
  /// the robots take what they then describe, and put bodies in these places.
  std::vector<Placed> make(std::span<const Edit> edits, const Stage& stage,
                           std::vector<EventRecord>& events) const;
  /// Sets the attributes in the world, which must be as world::Attributes::set() demands.
  void describe(std::span<const Edit> edits) const;

  /// The edits that cannot be made, except for lack of room for a body, which depends on the
  /// run.
  std::vector<EditRefused> refused(std::span<const DueEdits> schedule, const Stage& stage) const;

 private:
  const world::World& world_;
  world::Attributes attributes_;
};

}  // namespace elsie::simulation
