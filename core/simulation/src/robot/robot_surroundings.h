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
#include "elsie/world/things.h"

#include "robot/robot.h"
#include "step/fields.h"
#include "step/neighbours.h"

namespace elsie::simulation {

using Robots = std::span<const std::shared_ptr<Robot>>;

/// A mate as it tells of itself: distance and bearing follow from what both believe.
inline TeamMate believed_by(const Robot& observer, const Robot& other) {
  const Pose &here = observer.state().pose, &there = other.state().pose;
  return {other.state().id,        there,
          distance(here, there),   bearing(here, there.x, there.y),
          other.state().is_leader, other.state().team_index};
}

/// Memory of one thread that is used again for each robot.
struct SensingMemory {
  std::vector<base::Grid::Id> near;
  std::vector<RayQuery> rays;
};

class RobotSurroundings final : public Surroundings {
 public:
  RobotSurroundings(const physics::Engine& engine, const world::Things& things,
                    const Fields& fields, Robots robots, const Neighbours& neighbours,
                    std::size_t robot, SensingMemory& memory)
      : engine_(engine),
        things_(things),
        fields_(fields),
        robots_(robots),
        neighbours_(neighbours),
        robot_(robot),
        memory_(memory) {}

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
    return engine_.anything_in(pyramid, robot_);
  }
  Thing thing(const Surface& surface) const override { return things_.of(surface); }
  Pose pose() const override { return robots_[robot_]->truth().pose; }
  const OwnState& self() const override { return robots_[robot_]->state(); }
  std::span<const JointSetting> joints() const override { return robots_[robot_]->joints(); }
  std::span<const Contact> contacts() const override { return robots_[robot_]->contacts(); }
  BodyMotion motion() const override { return engine_.motion(robot_); }
  Motion rolled() const override { return robots_[robot_]->rolled(); }
  Colour floor_colour(const Vector2& place) const override { return things_.floor_colour(place); }
  double field(std::string_view id, const Vector2& place) const override {
    return fields_[fields_.index(id)].value(place);
  }
  std::span<const LampView> lamps() const override { return things_.lamps(); }
  void things_within(double radius_m, std::vector<NearThing>& things) const override {
    const auto place_of = [this](std::size_t i) -> std::optional<Vector2> {
      if (!engine_.has_obstacle(i)) return std::nullopt;
      const Vector3 at = engine_.obstacle(i).origin;
      return Vector2{at.x, at.y};
    };
    things_.within(pose(), radius_m, place_of, things);
    const Pose here = pose();
    for (const std::size_t i : neighbours_.near({here.x, here.y}, radius_m, memory_.near)) {
      if (i != robot_) things_.add_robot(i, here, robots_[i]->truth().pose, radius_m, things);
    }
  }
  /// Calls visit(robot) for all other robots whose middles are within `reach_m`, and perhaps
  /// others, in their order.
  template <class Visit>
  void for_each_near(double reach_m, const Visit& visit) const {
    const Pose here = pose();
    for (const std::size_t i : neighbours_.near({here.x, here.y}, reach_m, memory_.near)) {
      if (i != robot_) visit(*robots_[i]);
    }
  }
  /// Whether nothing but the other robot is between two places.
  bool sees(const Robot& other, const Vector3& from, const Vector3& to) const {
    const Vector3 way = to - from;
    const double distance = std::sqrt(dot(way, way));
    if (!(distance > 0.0)) return true;
    const auto hit = engine_.cast_ray(from, (1.0 / distance) * way, distance, robot_);
    if (!hit || hit->floor) return !hit;
    return hit->body.kind == physics::BodyKind::robot && robots_[hit->body.index].get() == &other;
  }
  void lights_within(double radius_m, std::vector<LampView>& lights) const override {
    for_each_near(radius_m, [&](const Robot& other) {
      if (distance(pose(), other.truth().pose) <= radius_m) other.list_lights(lights);
    });
  }
  std::span<const Colour> resource_colours() const override {
    return robots_[robot_]->resource_colours();
  }

  SensingMemory& memory() const { return memory_; }

 private:
  const physics::Engine& engine_;
  const world::Things& things_;
  const Fields& fields_;
  Robots robots_;
  const Neighbours& neighbours_;
  std::size_t robot_;
  SensingMemory& memory_;
};

}  // namespace elsie::simulation
