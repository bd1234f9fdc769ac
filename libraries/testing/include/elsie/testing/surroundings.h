// A made-up world for sensors.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/sensor.h"
#include "elsie/testing/picture.h"
#include "elsie/world/description.h"

namespace elsie::world {
class Things;
}

namespace elsie::testing {

///   Surroundings room;
///   room.wall(1.0, -2, 1.0, 2).box(0.5, 0.3).robot("mate", 2, 0).at(0, 0, 90);
///
/// Boxes, walls and robots on an endless floor, seen by cameras, and by rays and volumes as in a
/// simulation. Lengths are in m, angles in degrees; nothing moves. The robot that carries the
/// sensor is at the origin and looks east unless at() changes that; it is invisible.
class Surroundings final : public elsie::Surroundings {
 public:
  Surroundings();
  ~Surroundings();
  Surroundings(Surroundings&&) noexcept;
  Surroundings& operator=(Surroundings&&) noexcept;

  /// Sets the carrier's pose.
  Surroundings& at(double x, double y, double heading_deg = 0.0);
  /// Adds a box that stands on the floor with its middle there.
  Surroundings& box(double x, double y, double length = 0.2, double width = 0.2,
                    double height = 0.2, double heading_deg = 0.0);
  /// Adds a thin wall (1 cm, 0.3 m high) from one point to the other; its middle is on the line.
  Surroundings& wall(double x1, double y1, double x2, double y2);
  /// Adds a resource that the carrier may collect: a box of 0.2 m in this colour.
  Surroundings& resource(double x, double y, const Colour& colour = kRed);
  /// Adds another robot.
  Surroundings& robot(const std::string& id, double x, double y, double heading_deg = 0.0,
                      bool is_leader = false);
  /// The same with a body that is not the default one: round, say, or with segments.
  Surroundings& robot(const world::Robot& robot);

  /// Adds a mark at which robots of any team charge.
  Surroundings& charger(double x, double y, double radius = 0.15);
  Surroundings& lamp(double x, double y, double z = 0.5, double intensity = 1.0,
                     const Colour& colour = {255, 255, 255});
  /// Adds what an actuator of another robot shines, without that robot's body.
  Surroundings& light(const std::string& robot, const Vector3& place, double intensity = 0.1,
                      const Colour& colour = {255, 255, 255});
  /// Paints the whole floor, or a patch on it.
  Surroundings& floor(const Colour& colour);
  Surroundings& patch(const world::Patch& patch);
  /// Sets the value of a field at every place; fields that are not set are 0.
  Surroundings& field(const std::string& id, std::function<double(const Vector2&)> value);
  /// Adds a touch of the carrier's body with the last box, wall or robot that was added.
  Surroundings& touch(const Vector3& place, const Vector3& normal, double impulse_n_s = 0.01,
                      int segment = 0);
  Surroundings& moving(const BodyMotion& motion);
  Surroundings& joints(std::vector<JointSetting> joints);

  /// The carrier's own state, to be set.
  OwnState carrier;

  std::optional<double> cast_ray(const Vector3& origin, const Vector3& direction,
                                 double max_range_m) const override;
  using elsie::Surroundings::cast_rays;
  void cast_rays(const Frame& within, std::span<RayQuery> rays,
                 std::span<Surface> surfaces) const override;
  bool anything_in(const Pyramid& pyramid) const override;
  Thing thing(const Surface& surface) const override;
  Pose pose() const override { return pose_; }
  const OwnState& self() const override { return carrier; }
  std::span<const JointSetting> joints() const override { return joints_; }
  std::span<const Contact> contacts() const override { return contacts_; }
  BodyMotion motion() const override { return motion_; }
  /// What follows from the carrier's odometry in a control period of 0.01 s.
  Motion rolled() const override { return 0.01 * carrier.odometry; }
  void lights_within(double radius_m, std::vector<LampView>& lights) const override;
  Colour floor_colour(const Vector2& place) const override;
  double field(std::string_view id, const Vector2& place) const override;
  std::span<const LampView> lamps() const override;
  void things_within(double radius_m, std::vector<NearThing>& things) const override;
  std::span<const Colour> resource_colours() const override { return colours_; }

  /// The picture of a camera that looks along the frame's forward axis. Needs EGL; throws
  /// render::RenderError with a sentence if the machine has none.
  Image photograph(const Frame& frame, const Camera& camera) const;
  /// The surroundings as plain data.
  const world::World& world() const { return world_; }

 private:
  struct Engine;

  Surroundings& add(const world::Obstacle& box);
  const world::Things& things() const;

  Pose pose_;
  world::World world_;
  std::vector<JointSetting> joints_;
  std::vector<Contact> contacts_;
  BodyMotion motion_;
  std::vector<LampView> lights_;
  std::map<std::string, std::function<double(const Vector2&)>, std::less<>> fields_;
  std::set<std::string> names_;  // of their robots
  Surface last_;                 // what was added
  std::vector<Colour> colours_;
  std::unique_ptr<Engine> engine_;
};

}  // namespace elsie::testing
