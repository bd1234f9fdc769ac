// What a sensor may ask of the world around its robot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"
#include "elsie/api/image.h"
#include "elsie/api/perception.h"

namespace elsie {

/// A rectangular pyramid with its apex at the frame's origin and its axis along forward.
struct Pyramid {
  Frame frame;                    // in the world
  double horizontal_fov_rad = 0;  // the full angle
  double vertical_fov_rad = 0;    // the full angle
  double range_m = 0;             // height of the pyramid, along its axis
};

/// One of several rays that are cast in one query.
struct RayQuery {
  static constexpr double kNothing = std::numeric_limits<double>::infinity();

  const Frame* from = nullptr;  // it begins at the origin and runs forward
  double max_range_m = 0.0;
  double distance_m = kNothing;  // the answer: to the first surface; kNothing beyond the range
};

/// What a ray hit.
struct Surface {
  enum class Kind : std::uint8_t { nothing, floor, wall, obstacle, robot };

  Kind kind = Kind::nothing;
  std::size_t index = 0;  // of a wall, obstacle or robot among its kind, in the order of adding
  /// In the world, a unit vector, on the side from which the ray came; against the ray if that
  /// starts within the body. Zero for nothing.
  Vector3 normal;

  friend bool operator==(const Surface&, const Surface&) = default;
};

/// Something that sensors find, as the world describes it. Views are valid until the world changes.
struct Thing {
  enum class Kind : std::uint8_t { nothing, floor, wall, obstacle, resource, charger, robot };

  Kind kind = Kind::nothing;
  std::string_view id;    // of an obstacle, resource, charger or robot
  std::string_view team;  // of a robot; of a resource or charger, empty: any
  Colour colour;          // as pictures show it in full light
  bool is_mark = false;   // a charger that is a mark on the floor, and no body
};

/// A resource, a dynamic obstacle, a charger or a robot near the carrier.
struct NearThing {
  Thing thing;
  Vector2 place;             // m, its middle
  double distance_m = 0.0;   // from the carrier's true place
  double bearing_rad = 0.0;  // from its true heading, positive to the left
};

/// A place at which the carrier's body touched something other than the floor, in one step.
struct Contact {
  int segment = 0;  // 0: the robot itself; then its segments, counted backwards
  Surface other;
  Vector3 place;             // m, in the world
  Vector3 normal;            // in the world, a unit vector from the other body to the robot
  double impulse_n_s = 0.0;  // N s, that pressed along the normal in the step
};

/// A lamp of the world, or what an actuator of a robot shines.
struct LampView {
  std::string_view id;     // of the lamp, or of the robot
  Vector3 place;           // m
  double intensity = 1.0;  // see the law of each sensor
  Colour colour;
};

/// The true motion of the carrier's body: of the origin of its frame, in the world.
struct BodyMotion {
  Vector3 velocity;  // m/s
  Vector3 turning;   // rad/s
};

/// The queries that a sensor may make. They ignore the robot that carries the sensor. Those that
/// have a default answer it as in an empty world.
class Surroundings {
 public:
  /// The distance in metres from `origin` to the first surface that range sensors see, along
  /// `direction` (a unit vector), both in the world frame; none beyond `max_range_m`.
  virtual std::optional<double> cast_ray(const Vector3& origin, const Vector3& direction,
                                         double max_range_m) const = 0;
  /// The same for all these rays, faster: sets their distances. Their frames are given in the frame
  /// `within`, as those of sensors in the robot's. Rays that start at one point are cheapest.
  void cast_rays(const Frame& within, std::span<RayQuery> rays) const {
    cast_rays(within, rays, {});
  }
  /// The same, and sets what each of them hit, unless there are no `surfaces`. Throws
  /// std::invalid_argument if they are not as many as the rays.
  virtual void cast_rays(const Frame& within, std::span<RayQuery> rays,
                         std::span<Surface> surfaces) const = 0;
  /// True if a body that proximity sensors see reaches into the volume. The floor does not count.
  virtual bool anything_in(const Pyramid& pyramid) const = 0;
  /// What a ray hit, and what a body touched.
  virtual Thing thing(const Surface& surface) const;
  /// Whether no surface that range sensors see is between two places, in the world frame.
  bool is_open(const Vector3& from, const Vector3& to) const;
  /// The true pose of the robot that carries the sensor.
  virtual Pose pose() const = 0;
  /// Its battery, its size, its wheels and so on. Pose and motion in it are what it believes.
  virtual const OwnState& self() const;
  /// Its measured joints; those that can be set.
  virtual std::span<const JointSetting> joints() const { return {}; }
  /// Its contacts in the steps since sensors were last updated. Empty unless a sensor of the robot
  /// declares feels_contacts().
  virtual std::span<const Contact> contacts() const { return {}; }
  virtual BodyMotion motion() const { return {}; }
  /// How far the carrier has rolled by its joints (OwnState::odometry) since sensors were last
  /// updated: m and rad.
  virtual Motion rolled() const { return {}; }
  /// The colour of the floor there: patches, image, marks of chargers.
  virtual Colour floor_colour(const Vector2& place) const;
  /// The value of a field at a place, units/m2, between those of the four nearest cells; outside of
  /// the arena that of the nearest place in it. Throws base::Error if there is no such field: see
  /// names_field().
  virtual double field(std::string_view /*id*/, const Vector2& /*place*/) const { return 0.0; }
  /// All lamps, in file order, also those that something hides.
  virtual std::span<const LampView> lamps() const { return {}; }
  /// Appends what actuators of other robots shine whose middles are within the radius of the
  /// carrier: a light may be nearer or farther by as much as it is away from the middle of its
  /// robot. In the order of the robots in the file, also lights that something hides.
  virtual void lights_within(double /*radius_m*/, std::vector<LampView>& /*lights*/) const {}
  /// Appends the resources that are still there and the dynamic obstacles, the chargers and the
  /// other robots whose middles are within the radius of the carrier, in this order, each in file
  /// order.
  virtual void things_within(double radius_m, std::vector<NearThing>& things) const;
  /// The colours of the resources that the carrier may collect, as cameras see them in full light:
  /// each once, in file order. They do not change during a run.
  virtual std::span<const Colour> resource_colours() const = 0;

 protected:
  ~Surroundings() = default;
};

}  // namespace elsie
