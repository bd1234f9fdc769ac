#include "elsie/testing/surroundings.h"

#include <algorithm>
#include <cmath>

#include "elsie/physics/engine.h"
#include "elsie/render/renderer.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/colours.h"
#include "elsie/world/parts.h"

namespace elsie::testing {

/// The simulator's bodies and rays.
struct Surroundings::Engine {
  std::unique_ptr<physics::Engine> bodies;
};

Surroundings::Surroundings() : engine_(std::make_unique<Engine>()) {
  world_.arena.walls = false;
  world_.teams = {{"red", world::kRedTeam, {}}};
  engine_->bodies = physics::make_engine(world_.arena, world_.physics);
}
Surroundings::~Surroundings() = default;
Surroundings::Surroundings(Surroundings&&) noexcept = default;
Surroundings& Surroundings::operator=(Surroundings&&) noexcept = default;

Surroundings& Surroundings::at(double x, double y, double heading_deg) {
  pose_ = {x, y, wrap_angle(radians(heading_deg))};
  return *this;
}

Surroundings& Surroundings::add(const world::Obstacle& box) {
  engine_->bodies->add_obstacle(box);
  world_.obstacles.push_back(box);
  return *this;
}

Surroundings& Surroundings::box(double x, double y, double length, double width, double height,
                                double heading_deg) {
  world::Obstacle box;
  box.id = "box" + std::to_string(world_.obstacles.size());
  box.x = x;
  box.y = y;
  box.length = length;
  box.width = width;
  box.height = height;
  box.heading_deg = heading_deg;
  return add(box);
}

Surroundings& Surroundings::wall(double x1, double y1, double x2, double y2) {
  constexpr double kThickness = 0.01;
  constexpr double kHeight = 0.3;
  return box(0.5 * (x1 + x2), 0.5 * (y1 + y2), std::hypot(x2 - x1, y2 - y1), kThickness, kHeight,
             degrees(std::atan2(y2 - y1, x2 - x1)));
}

Surroundings& Surroundings::resource(double x, double y, const Colour& colour) {
  world::Obstacle box;
  box.id = "resource" + std::to_string(world_.obstacles.size());
  box.kind = world::ObstacleKind::resource;
  box.x = x;
  box.y = y;
  box.colour = colour;
  if (std::find(colours_.begin(), colours_.end(), colour) == colours_.end()) {
    colours_.push_back(colour);
  }
  return add(box);
}

Surroundings& Surroundings::robot(const std::string& id, double x, double y, double heading_deg,
                                  bool is_leader) {
  world::Robot robot;
  robot.id = id;
  robot.x = x;
  robot.y = y;
  robot.heading_deg = heading_deg;
  robot.leader = is_leader;
  return this->robot(robot);
}

Surroundings& Surroundings::robot(const world::Robot& robot) {
  engine_->bodies->add_robot(world::plan_of(robot),
                             {robot.x, robot.y, wrap_angle(radians(robot.heading_deg))}, robot.z);
  world_.robots.push_back(robot);
  return *this;
}

std::optional<double> Surroundings::cast_ray(const Vector3& origin, const Vector3& direction,
                                             double max_range_m) const {
  const auto hit =
      engine_->bodies->cast_ray(origin, direction, max_range_m, physics::Engine::kNobody);
  return hit ? std::optional(hit->distance) : std::nullopt;
}

void Surroundings::cast_rays(const Frame& within, std::span<RayQuery> rays,
                             std::span<Surface> surfaces) const {
  engine_->bodies->cast_rays(within, rays, surfaces, physics::Engine::kNobody);
}

bool Surroundings::anything_in(const Pyramid& pyramid) const {
  return engine_->bodies->anything_in(pyramid, physics::Engine::kNobody);
}

std::optional<TeamMate> Surroundings::nearest_robot(double radius_m) const {
  std::vector<TeamMate> robots;
  robots_within(radius_m, robots);
  const auto nearest = std::min_element(
      robots.begin(), robots.end(),
      [](const TeamMate& a, const TeamMate& b) { return a.distance_m < b.distance_m; });
  return nearest == robots.end() ? std::nullopt : std::optional(*nearest);
}

void Surroundings::robots_within(double radius_m, std::vector<TeamMate>& robots) const {
  for (std::size_t i = 0; i < world_.robots.size(); ++i) {
    const world::Robot& other = world_.robots[i];
    const Pose pose{other.x, other.y, wrap_angle(radians(other.heading_deg))};
    if (distance(pose_, pose) <= radius_m) {
      // The carrier is the first of its team.
      robots.push_back({other.id, pose, distance(pose_, pose), bearing(pose_, pose.x, pose.y),
                        other.leader, static_cast<int>(i) + 1});
    }
  }
}

Image Surroundings::photograph(const Frame& frame, const Camera& camera) const {
  render::Renderer renderer;
  Image image;
  Image* const place[] = {&image};
  const render::View view{frame, camera, render::kNobody};
  renderer.render(render::WorldScene(world_).scene(), std::span(&view, 1), place);
  return image;
}

}  // namespace elsie::testing
