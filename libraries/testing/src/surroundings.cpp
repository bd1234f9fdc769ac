#include "elsie/testing/surroundings.h"

#include <algorithm>
#include <cmath>

#include "elsie/physics/engine.h"
#include "elsie/render/renderer.h"
#include "elsie/render/world_scene.h"
#include "elsie/world/colours.h"
#include "elsie/world/parts.h"
#include "elsie/world/things.h"

namespace elsie::testing {

/// The simulator's bodies and rays.
struct Surroundings::Engine {
  std::unique_ptr<physics::Engine> bodies;
  std::optional<world::Things> things;  // none: the world has changed
};

Surroundings::Surroundings() : engine_(std::make_unique<Engine>()) {
  world_.arena.walls = false;
  world_.teams = {{"red", world::kRedTeam, {}}};
  engine_->bodies = physics::make_engine(world_.arena, world_.physics);
}
Surroundings::~Surroundings() = default;
// What the engine's views refer to has moved.
Surroundings::Surroundings(Surroundings&& other) noexcept
    : carrier(other.carrier),
      pose_(other.pose_),
      world_(std::move(other.world_)),
      joints_(std::move(other.joints_)),
      contacts_(std::move(other.contacts_)),
      motion_(other.motion_),
      fields_(std::move(other.fields_)),
      last_(other.last_),
      colours_(std::move(other.colours_)),
      engine_(std::move(other.engine_)) {
  engine_->things.reset();
}
Surroundings& Surroundings::operator=(Surroundings&& other) noexcept {
  std::destroy_at(this);
  return *std::construct_at(this, std::move(other));
}

Surroundings& Surroundings::at(double x, double y, double heading_deg) {
  pose_ = {x, y, wrap_angle(radians(heading_deg))};
  return *this;
}

Surroundings& Surroundings::add(const world::Obstacle& box) {
  engine_->bodies->add_obstacle(box);
  last_ = {Surface::Kind::obstacle, world_.obstacles.size(), {}};
  world_.obstacles.push_back(box);
  engine_->things.reset();
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
  last_ = {Surface::Kind::robot, world_.robots.size(), {}};
  world_.robots.push_back(robot);
  engine_->things.reset();
  return *this;
}

Surroundings& Surroundings::charger(double x, double y, double radius) {
  world::Charger charger;
  charger.id = "charger" + std::to_string(world_.chargers.size());
  charger.x = x;
  charger.y = y;
  charger.radius = radius;
  world_.chargers.push_back(charger);
  engine_->things.reset();
  return *this;
}

Surroundings& Surroundings::light(const std::string& robot, const Vector3& place, double intensity,
                                  const Colour& colour) {
  lights_.push_back({*names_.insert(robot).first, place, intensity, colour});
  return *this;
}

Surroundings& Surroundings::lamp(double x, double y, double z, double intensity,
                                 const Colour& colour) {
  world_.lamps.push_back(
      {"lamp" + std::to_string(world_.lamps.size()), x, y, z, intensity, colour, {}});
  engine_->things.reset();
  return *this;
}

Surroundings& Surroundings::floor(const Colour& colour) {
  world_.floor.colour = colour;
  engine_->things.reset();
  return *this;
}

Surroundings& Surroundings::patch(const world::Patch& patch) {
  world_.patches.push_back(patch);
  engine_->things.reset();
  return *this;
}

Surroundings& Surroundings::field(const std::string& id,
                                  std::function<double(const Vector2&)> value) {
  fields_[id] = std::move(value);
  return *this;
}

double Surroundings::field(std::string_view id, const Vector2& place) const {
  const auto found = fields_.find(id);
  return found == fields_.end() ? 0.0 : found->second(place);
}

Surroundings& Surroundings::touch(const Vector3& place, const Vector3& normal, double impulse_n_s,
                                  int segment) {
  contacts_.push_back({segment, {last_.kind, last_.index, normal}, place, normal, impulse_n_s});
  return *this;
}

Surroundings& Surroundings::moving(const BodyMotion& motion) {
  motion_ = motion;
  return *this;
}

Surroundings& Surroundings::joints(std::vector<JointSetting> joints) {
  joints_ = std::move(joints);
  return *this;
}

const world::Things& Surroundings::things() const {
  if (!engine_->things) engine_->things.emplace(world_);
  return *engine_->things;
}

Thing Surroundings::thing(const Surface& surface) const { return things().of(surface); }

Colour Surroundings::floor_colour(const Vector2& place) const {
  return things().floor_colour(place);
}

void Surroundings::lights_within(double radius_m, std::vector<LampView>& lights) const {
  std::copy_if(lights_.begin(), lights_.end(), std::back_inserter(lights),
               [&](const LampView& light) {
                 return std::hypot(light.place.x - pose().x, light.place.y - pose().y) <= radius_m;
               });
}

std::span<const LampView> Surroundings::lamps() const { return things().lamps(); }

void Surroundings::things_within(double radius_m, std::vector<NearThing>& found) const {
  const auto place_of = [this](std::size_t i) {
    return std::optional(Vector2{world_.obstacles[i].x, world_.obstacles[i].y});
  };
  things().within(pose_, radius_m, place_of, found);
  for (std::size_t i = 0; i < world_.robots.size(); ++i) {
    const world::Robot& other = world_.robots[i];
    things().add_robot(i, pose_, {other.x, other.y, radians(other.heading_deg)}, radius_m, found);
  }
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

Image Surroundings::photograph(const Frame& frame, const Camera& camera) const {
  render::Renderer renderer;
  Image image;
  Image* const place[] = {&image};
  const render::View view{frame, camera, render::kNobody};
  renderer.render(render::WorldScene(world_).scene(), std::span(&view, 1), place);
  return image;
}

}  // namespace elsie::testing
