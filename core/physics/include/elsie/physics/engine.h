// The interface of physics engines. Engines are libraries of their own, found by name at run time
// (plugins/engines). Lengths are in m, times in s, rates in rad/s, in the world's frame.
//
// An engine is built once (robots and obstacles are added), then stepped. Later changes need a new
// engine, which copies the state of all unchanged bodies from the old one. Engines in one process
// are independent. The same calls on two engines give bit-identical states.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/api/sensor.h"
#include "elsie/base/fnv1a.h"
#include "elsie/base/thread_pool.h"
#include "elsie/world/description.h"

namespace elsie::physics {

/// A robot or an obstacle, by its index in the order of adding. A robot includes its segments.
/// Walls are bodies, too: 0 east (+x), 1 north (+y), 2 west, 3 south, all outside of the arena's
/// area.
enum class BodyKind : std::uint8_t { robot, obstacle, wall };
struct Body {
  BodyKind kind = BodyKind::wall;
  std::size_t index = 0;  // among its kind

  friend auto operator<=>(const Body&, const Body&) = default;  // NOLINT(modernize-use-nullptr)
};

/// The state of a robot's body.
struct RobotState {
  Frame frame;             // origin below the middle of the chassis, at wheel-bottom height
  Pose pose;               // projected onto the floor
  double speed = 0.0;      // m/s along the heading
  double lateral = 0.0;    // m/s to the left
  double turn_rate = 0.0;  // rad/s counter-clockwise
};

/// The state of a segment that a robot pulls.
struct SegmentState {
  Frame frame;             // origin below the middle of its axle, at wheel-bottom height
  Pose pose;               // projected onto the floor
  double yaw_rad = 0.0;    // of its joint, counter-clockwise; 0: in line with the body in front
  double pitch_rad = 0.0;  // of its joint; positive if its front points up
};

/// Two bodies that touched during the last step; a < b. Each pair once, in ascending order. The
/// floor is not listed, and neither is a robot that its own segments touch. Bodies touch when there
/// is no gap between them at the beginning of the step (to within 0.02 mm); a body that stops at a
/// wall touches it in the next step.
struct Touch {
  Body a;
  Body b;

  friend auto operator<=>(const Touch&, const Touch&) = default;  // NOLINT(modernize-use-nullptr)
};

/// A place at which a robot touched another body in the last step.
struct BodyContact {
  std::size_t vehicle = 0;  // 0: the robot itself; then its segments, counted backwards from it
  Body other;
  Vector3 point;    // in the world, m
  Vector3 normal;   // in the world, a unit vector from the other body to the robot
  Vector3 impulse;  // in the world, N s, of the whole step on the robot, friction included

  /// The part of the impulse that presses.
  double pressing() const { return dot(impulse, normal); }

  friend bool operator==(const BodyContact&, const BodyContact&) = default;
};

/// Steps in which the engine found no motion that satisfies all constraints: contacts, joints and
/// motors. It has then relaxed them.
struct GiveUps {
  std::uint64_t steps = 0;
  std::uint64_t unsolved = 0;  // of them: relaxing did not help, and the motion is approximate
  double first_s = 0.0;        // the end of the first such step

  friend bool operator==(const GiveUps&, const GiveUps&) = default;
};

struct RayHit {
  double distance = 0.0;  // m; 0 for a ray that starts inside of a body
  Body body;
  bool floor = false;  // then `body` means nothing
};

/// Indices are those that add_robot() and add_obstacle() returned; others throw std::out_of_range.
/// Several threads may call const functions at once between steps.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Adds a robot at the pose, its wheels `z` m above the floor, its segments in line behind it;
  /// returns its index. Throws std::invalid_argument for dimensions and masses that are not
  /// positive and finite.
  virtual std::size_t add_robot(const BodyPlan& plan, const Pose& pose, double z = 0.0) = 0;
  /// Adds an obstacle; returns its index. Resources are fixed obstacles until they are removed.
  /// Fixed and moving obstacles float where z is positive, dynamic ones fall. Throws as add_robot()
  /// does.
  virtual std::size_t add_obstacle(const world::Obstacle& obstacle) = 0;
  /// Adds a robot of another engine of the same library, in its state there: pose, velocities,
  /// values and set points of its joints.
  virtual std::size_t add_robot_of(const Engine& other, std::size_t robot) = 0;
  /// The same with another body: it is upright at this pose, has its joints as in a new robot, and
  /// keeps its velocity. Throws as add_robot() does.
  virtual std::size_t add_robot_of(const Engine& other, std::size_t robot, const BodyPlan& plan,
                                   const Pose& pose) = 0;
  /// Adds an obstacle of another engine in its state there, even if it was removed there. `added`:
  /// its description in that engine.
  virtual std::size_t add_obstacle_of(const Engine& other, std::size_t obstacle,
                                      const world::Obstacle& added) = 0;
  /// Continues from another engine: its time, its give-ups, and everything that set bodies in
  /// motion there.
  virtual void go_on_from(const Engine& other) = 0;
  /// Removes an obstacle from the world, until place_obstacle().
  virtual void remove_obstacle(std::size_t obstacle) = 0;

  /// Moves a robot to another pose, at rest, with its segments in line behind it. The set points of
  /// its motors stay. Throws as add_robot() does.
  virtual void place_robot(std::size_t robot, const Pose& pose, double z = 0.0) = 0;

  /// Lets a robot hold a dynamic obstacle: from the next step on, the obstacle keeps its place in
  /// the frame of the robot. One with several `hands` is pinned where the robot grips it, `at` in
  /// the frame of the obstacle, m, and may turn there. The two do not touch each other. When as
  /// many robots as it has hands hold an obstacle, it moves with them, and glides over the floor
  /// without friction and without a weight on them; before, what has several does not move. Throws
  /// std::invalid_argument if it is not there, or as many hold it already.
  virtual void hold(std::size_t robot, std::size_t obstacle, const Vector2& at) = 0;
  /// Lets go of it, if the robot holds it.
  virtual void let_go(std::size_t robot, std::size_t obstacle) = 0;

  /// Moves an obstacle to another pose, at rest and as high as it was when it was added; one that
  /// was removed is there again. Whoever holds it must let go. Throws std::invalid_argument for a
  /// pose that is not finite.
  virtual void place_obstacle(std::size_t obstacle, const Pose& pose) = 0;

  /// Why no robot can stand so high, in a sentence that begins with "the robot"; none: it can.
  virtual std::optional<std::string> fault_of_height(double /*z*/) const { return std::nullopt; }

  /// Sets the set points of a robot's joints that can be set (can_be_set()), in the order of its
  /// parts. The caller limits rates to those that the motors can make. Throws std::invalid_argument
  /// if the number of settings is wrong or one is not finite. Several threads may call this at once
  /// for different robots.
  virtual void set_joints(std::size_t robot, std::span<const JointSetting> settings) = 0;
  /// Measured values of these joints; valid until the next step.
  virtual std::span<const JointSetting> joints(std::size_t robot) const = 0;
  /// Sets the position of a moving obstacle at the end of the next step and its velocity (m/s);
  /// other bodies do not stop it. Call this before each step; otherwise the obstacle rests in the
  /// step.
  virtual void drive_obstacle(std::size_t obstacle, const Vector2& position,
                              const Vector2& velocity) = 0;

  /// From now on step() may give parts of its work to this pool, which outlives the engine. The
  /// states are the same with any pool and without one.
  virtual void work_with(base::ThreadPool& /*pool*/) {}
  /// One step of the length in world::Physics. Throws PhysicsFailure when the state of a body is no
  /// longer finite, or the body is at a place that nothing in the world could have moved it to
  /// (bounds.h). The state then stays as it is for inspection; further steps are meaningless.
  virtual void step() = 0;

  /// How often the solver has given up since the engine was made.
  virtual GiveUps give_ups() const = 0;

  virtual RobotState robot(std::size_t robot) const = 0;
  /// The number of segments that a robot pulls, and one of them, counted from the robot backwards.
  virtual std::size_t segments(std::size_t robot) const = 0;
  virtual SegmentState segment(std::size_t robot, std::size_t segment) const = 0;
  virtual Frame obstacle(std::size_t obstacle) const = 0;  // origin in the middle of its bottom
  virtual bool has_obstacle(std::size_t obstacle) const = 0;
  /// Contacts of the last step.
  virtual std::span<const Touch> touches() const = 0;

  /// From the next step on, contacts() has this robot's. States stay the same bit for bit. A robot
  /// that another engine adds of this one is watched there, too.
  virtual void watch_contacts(std::size_t robot) = 0;
  /// Where a watched robot touched something other than the floor and itself in the last step: at
  /// its beginning (to within 0.02 mm) or with an impulse. Ordered by vehicle, body and place;
  /// valid until the next step. A surface that is met all over has a contact at each of a few
  /// points.
  virtual std::span<const BodyContact> contacts(std::size_t robot) const = 0;
  /// The motion of a robot's body in space.
  virtual BodyMotion motion(std::size_t robot) const = 0;

  /// The first surface along a ray (`direction` a unit vector), no further away than `max_range`,
  /// as range sensors see the world: floor (from above), walls, obstacles that are visible to them,
  /// and robots (wheels and chassis). A chassis with a flat top has a sensor deck of 2 cm on it, so
  /// that sensors at the top of a chassis see robots of the same size; segments likewise. The robot
  /// `except` and its segments are left out. Of bodies at the same distance, the first in their
  /// order is hit.
  virtual std::optional<RayHit> cast_ray(const Vector3& origin, const Vector3& direction,
                                         double max_range, std::size_t except) const = 0;
  /// The same for several rays, whose frames are given in the frame `within`: sets their distances.
  /// Rays that follow each other and start at one point share the search for bodies. Only one
  /// thread at a time may ask for a robot.
  void cast_rays(const Frame& within, std::span<RayQuery> rays, std::size_t except) const {
    cast_rays(within, rays, {}, except);
  }
  /// The same, and sets what each of them hit, unless there are no `surfaces`. Throws
  /// std::invalid_argument if they are not as many as the rays.
  virtual void cast_rays(const Frame& within, std::span<RayQuery> rays, std::span<Surface> surfaces,
                         std::size_t except) const = 0;
  /// Returns whether a wall, a visible obstacle or a robot other than `except` reaches into the
  /// pyramid, whose far face is flat, at the distance `range_m` along its axis. Robots are seen as
  /// by rays, but with the boxes around their wheels, and around a chassis that is a ball or a
  /// capsule. The floor does not count.
  virtual bool anything_in(const Pyramid& pyramid, std::size_t except) const = 0;
  /// For `except`: no robot is left out.
  static constexpr std::size_t kNobody = static_cast<std::size_t>(-1);

  /// FNV-1a (64 bits) over position, orientation, linear and angular velocity of every body,
  /// continuing from `hash`.
  virtual std::uint64_t hash_state(std::uint64_t hash = base::Fnv1a::kStart) const = 0;
};

/// Makes the engine that `physics.engine` names. Throws plugin::PluginError if there is none, and
/// std::invalid_argument for an arena or parameters that it cannot use.
std::unique_ptr<Engine> make_engine(const world::Arena& arena, const world::Physics& physics);

/// The function that the library of an engine exports as `elsie_make_engine`; it also exports a
/// world::EngineParameters, a world::EngineCheck and a world::EngineWarnings. The caller owns the
/// engine. Throws std::invalid_argument as make_engine() does.
using EngineEntry = Engine* (*)(const world::Arena& arena, const world::Physics& physics);

/// The object that it exports as `elsie_engine_interface`: the version of this header (raise it
/// with every change) and the sizes of the structs that pass through. The plugin interface has a
/// version of its own.
struct EngineInterface {
  std::uint32_t version = 8;
  std::size_t arena = sizeof(world::Arena);
  std::size_t physics = sizeof(world::Physics);
  std::size_t obstacle = sizeof(world::Obstacle);
  std::size_t plan = sizeof(BodyPlan);

  friend bool operator==(const EngineInterface&, const EngineInterface&) = default;
};

}  // namespace elsie::physics
