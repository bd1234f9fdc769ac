// The queries of one robot's sensors.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "elsie/api/perception.h"
#include "elsie/api/sensor.h"
#include "elsie/physics/engine.h"

#include "robot/robot.h"
#include "step/neighbours.h"

namespace elsie::simulation {

using Robots = std::span<const std::shared_ptr<Robot>>;

/// One robot as perceived by another one.
inline TeamMate seen_from(Robots robots, std::size_t observer, std::size_t other) {
  const Pose& from = robots[observer]->state().pose;
  const OwnState& state = robots[other]->state();
  return {state.id,
          state.pose,
          distance(from, state.pose),
          bearing(from, state.pose.x, state.pose.y),
          state.is_leader,
          state.team_index};
}

/// Memory of one thread that is used again for each robot.
struct SensingMemory {
  std::vector<base::Grid::Id> near;
  std::vector<RayQuery> rays;
  Pyramid volume;
};

class RobotSurroundings final : public Surroundings {
 public:
  RobotSurroundings(const physics::Engine& engine, Robots robots, const Neighbours& neighbours,
                    std::size_t robot, SensingMemory& memory)
      : engine_(engine), robots_(robots), neighbours_(neighbours), robot_(robot), memory_(memory) {}

  std::optional<double> cast_ray(const Vector3& origin, const Vector3& direction,
                                 double max_range_m) const override {
    const auto hit = engine_.cast_ray(origin, direction, max_range_m, robot_);
    return hit ? std::optional(hit->distance) : std::nullopt;
  }
  void cast_rays(const Frame& within, std::span<RayQuery> rays,
                 std::span<Surface> surfaces) const override {
    engine_.cast_rays(within, rays, surfaces, robot_);
  }
  bool anything_in(const Pyramid& pyramid) const override {
    memory_.volume = pyramid;
    has_volume_ = true;
    return engine_.anything_in(pyramid, robot_);
  }
  Pose pose() const override { return robots_[robot_]->state().pose; }
  std::optional<TeamMate> nearest_robot(double radius_m) const override {
    std::optional<TeamMate> nearest;
    for_each_within(radius_m, [&](const TeamMate& other) {
      if (!nearest || other.distance_m < nearest->distance_m) {
        nearest = other;
      }
    });
    return nearest;
  }
  void robots_within(double radius_m, std::vector<TeamMate>& robots) const override {
    for_each_within(radius_m, [&](const TeamMate& other) { robots.push_back(other); });
  }
  std::span<const Colour> resource_colours() const override {
    return robots_[robot_]->resource_colours();
  }

  SensingMemory& memory() const { return memory_; }
  /// The volume of the last query since the last call, for viewers; null: there was none.
  const Pyramid* take_volume() const {
    return std::exchange(has_volume_, false) ? &memory_.volume : nullptr;
  }

 private:
  template <class Visit>
  void for_each_within(double radius_m, Visit visit) const {
    const Pose here = pose();
    for (const std::size_t i : neighbours_.near({here.x, here.y}, radius_m, memory_.near)) {
      if (i != robot_) {
        const TeamMate other = seen_from(robots_, robot_, i);
        if (other.distance_m <= radius_m) {
          visit(other);
        }
      }
    }
  }

  const physics::Engine& engine_;
  Robots robots_;
  const Neighbours& neighbours_;
  std::size_t robot_;
  SensingMemory& memory_;
  mutable bool has_volume_ = false;
};

}  // namespace elsie::simulation
