// The body of an obstacle, a resource or a wall.
#pragma once

#include <vector>

#include "elsie/base/fnv1a.h"
#include "elsie/world/description.h"
#include "elsie/world/parts.h"

#include "ode_contacts.h"
#include "ode_handles.h"
#include "part_bodies.h"
#include "scene.h"
#include "solids.h"

namespace elsie::physics {

struct BoxBody {
  /// Makes the body at the place of the fixture. `mass`: kg, of a dynamic one. Throws OdeFailure if
  /// ODE cannot use the mass.
  BoxBody(dWorldID world, world::ObstacleKind kind_of_box, const world::Fixture& fixture,
          double mass);

  bool is_carried() const { return holders > 0 && holders >= hands; }
  /// Whether it can be pushed, or is carried.
  bool gives_way() const {
    return kind == world::ObstacleKind::dynamic && (hands == 1 || is_carried());
  }
  /// Call it when the robots that hold it have changed.
  void take_footing();

  bool is_mobile() const {
    return kind == world::ObstacleKind::dynamic || kind == world::ObstacleKind::moving;
  }
  Solid solid() const { return {body, geom.get(), form, shape, solid_shape.outline}; }
  /// Its origin is in the middle of its lower side.
  Frame frame() const {
    const auto& [forward, left, up] = shape.axes;
    return {shape.center - shape.half.z * up, forward, left, up};
  }
  void meet_floor(OdeContacts& contacts) const;
  /// Puts it there upright and at rest, as high as it was made.
  void put(const Pose& pose);
  /// Takes the place of a body that ODE has moved.
  void read_shape();
  /// The highest speed of any of its points, m/s.
  double most_speed() const;
  void add_to(base::Fnv1a& hash) const;

  world::ObstacleKind kind;
  bool present = true;
  Scene::Id id = 0;
  dBodyID body = nullptr;  // null for a fixed body
  OdeGeom geom;
  Shape solid_shape;
  SolidKind form = SolidKind::box;
  OrientedBox shape;          // bounding box
  double made_z = 0.0;        // m, its middle
  bool stays_within = false;  // within the arena's walls
  int hands = 1;              // that move it
  int holders = 0;
  // For a moving box: its place at the end of the next step.
  bool driven = false;
  Vector3 target;

 private:
  void take_shape();

  ConvexArrays convex_;  // what the geometry of a prism refers to
};

}  // namespace elsie::physics
