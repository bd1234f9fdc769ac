// What stands where: the scene of the engine's world with the last snapshot.
#pragma once

#include <QHash>
#include <QPointF>
#include <QString>
#include <optional>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/render/scene.h"
#include "elsie/snapshots/snapshots.h"

#include "engine/json.h"

namespace elsie::desktop {

class Stage {
 public:
  struct Body {
    QString path;  // of its element: "robot[r1]"
    int vehicle = 0;
    Colour colour;  // of its first solid
    Frame frame;
    bool is_present = true;
    double coverage = 0.0;  // m, of a robot: how far it perceives its team

    /// Whether this is the first vehicle of a robot's train.
    bool is_robot() const { return vehicle == 0 && path.startsWith("robot["); }
  };
  /// A part of a body, or of the arena.
  struct Solid {
    Shape shape;
    Frame frame;  // of its middle in the body's frame
    Colour colour;
    int body = -1;  // -1: the arena's
    QString path;
    render::Material material = render::Material::plain;
    bool is_chassis = false;
    double turned_rad = 0.0;  // a wheel, by the way that it has rolled
  };
  /// The place of a goal.
  struct Goal {
    Vector2 at;
    double radius = 0.0;
    int body = -1;  // in whose frame it is; -1: the world
    QString whose;
  };

  /// Reads a scene; an invalid one leaves the stage empty. Returns whether it was valid.
  bool set_scene(const Json& scene, std::uint64_t epoch);
  /// Takes the fields of an event `state`.
  void take_fields(const Json& fields);
  /// Whether the world has fields.
  bool has_fields() const { return has_fields_; }
  /// Takes what shines, of an event `state`.
  void take_lights(const Json& lights);
  /// Whether the world has actuators, which may shine.
  bool has_actuators() const { return has_actuators_; }
  /// Takes a snapshot, and keeps it until its scene is there. Returns whether the bodies moved.
  bool take(const snapshots::Snapshot& snapshot);

  bool is_empty() const { return solids_.empty(); }
  double length() const { return length_; }  // of the arena, m
  double width() const { return width_; }
  /// Whether an element has no body: a patch of the floor, a nest, or a lamp.
  static bool is_bodiless(const QString& path) {
    return is_patch(path) || path.startsWith("lamp[");
  }
  /// Whether it lies flat on the floor.
  static bool is_patch(const QString& path) {
    return path.startsWith("patch[") || path.startsWith("nest[");
  }
  /// Whether the last snapshot showed something that the one before did not.
  bool has_changed() const { return has_changed_; }
  bool has_own_floor() const { return floor_.has_value() || image_.pixels || with_fields_; }
  /// The goals' places, now.
  std::vector<Goal> goals() const;
  /// Where a sensor is, and where it looks; none if the path is not that of a sensor.
  std::optional<Frame> sensor_frame(const QString& path) const;
  /// Where a robot's eyes would be: above the front of its chassis.
  std::optional<Frame> seat_of(const QString& robot) const;
  /// The number of a robot's body, which carries its solids; render::kNobody if there is none.
  std::size_t carrier_of(const QString& robot) const;
  /// The height of the highest wall, m.
  double height() const;
  double time_s() const { return time_s_; }
  /// Whether the shown time is earlier than the latest one.
  bool is_past() const { return time_s_ < latest_s_; }
  const std::vector<Body>& bodies() const { return bodies_; }
  /// What plugins draw.
  const std::vector<snapshots::MarkState>& marks() const { return marks_; }
  /// Marks for which the snapshot had no room.
  std::uint64_t left_out() const { return facts_.left_out; }
  const std::vector<Solid>& solids() const { return solids_; }
  /// The chassis of a robot's first vehicle; null for another body.
  const Solid* chassis_of(const Body& body) const;
  /// The frame of a solid in the world.
  Frame frame_of(const Solid& solid) const;
  /// The first body of the element; null if it has none.
  const Body* body_of(const QString& path) const;
  /// The first solid of the element; null if it has none.
  const Solid* solid_of(const QString& path) const;
  /// Where the element stands on the floor; none if it has no place of its own, or is absent.
  std::optional<Frame> place_of(const QString& path) const;
  bool is_present(const Solid& solid) const;
  /// Whether no object is nearer to that point of the floor than `room`, in m.
  bool is_free(const QPointF& at, double room) const;

  /// Whether a wall or an obstacle is between these places.
  bool is_hidden(const Vector3& place, const Vector3& from) const;

  /// Everything that must be drawn.
  render::Scene drawn() const;
  /// The first element that a ray meets; "" for the floor, a wall or nothing. `way`: receives how
  /// far that is, in lengths of `direction`.
  QString at(const Vector3& from, const Vector3& direction, double* way = nullptr) const;

 private:
  void read(const Json& scene);
  void place();
  void roll_wheels(const std::vector<Body>& before);
  void add_front(render::Scene& scene, const Solid& chassis) const;

  std::uint64_t epoch_ = 0;
  double length_ = 0.0, width_ = 0.0;
  std::optional<Colour> floor_;
  render::FloorImage image_;
  render::FloorImage ground_;  // what fields lie on: the image and the patches
  bool has_fields_ = false, has_actuators_ = false;
  std::optional<render::FloorImage> with_fields_;  // none: they have not come yet
  double time_s_ = 0.0;
  double latest_s_ = 0.0;  // the latest time that was shown
  std::vector<Body> bodies_;
  std::vector<Solid> solids_;
  std::vector<Solid> lights_;  // what robots shine
  std::vector<Goal> goals_;
  QHash<QString, std::pair<int, Frame>> sensors_;  // their bodies, and the frames in these
  std::vector<int> chassis_;  // of each body, the number of its solid; -1: none
  bool is_placed_ = false;    // the bodies have been placed once
  bool has_changed_ = true;
  std::vector<snapshots::MarkState> marks_;
  // The last snapshot, perhaps of the next scene.
  snapshots::SnapshotFacts facts_;
  std::vector<snapshots::BodyState> states_;
  std::vector<snapshots::MarkState> states_of_marks_;
};

double heading_rad(const Frame& frame);

/// The edges of a solid over its outline, with some lines of its side, as pairs of points.
std::vector<std::pair<Vector3, Vector3>> edges_of(const Stage::Solid& solid, const Frame& frame);

}  // namespace elsie::desktop
