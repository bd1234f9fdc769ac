// The table of shapes: all that the program knows of a shape as such. What draws shapes, names
// them, lets them meet or computes how they move asks here, so that it needs no cases of its own.
//
// Two places add what only they need: world/src/obstacle_shapes.cpp the elements of obstacles in
// world files, plugins/engines the geometries of ODE. Lengths are in m, masses in kg.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie {

/// A solid whose middle is the origin of its frame.
struct Shape {
  enum class Kind : std::uint8_t { box, cylinder, sphere, capsule, prism };
  enum class Axis : std::uint8_t { forward, left, up };
  static constexpr std::array kKinds{"box", "cylinder", "sphere", "capsule", "prism"};
  static constexpr std::array kAxes{"forward", "left", "up"};

  Kind kind = Kind::box;
  Vector3 size;                    // of its bounding box, along the axes of its frame
  Axis axis = Axis::up;            // of a cylinder or capsule
  std::vector<Vector2> outline{};  // of a prism: the corners seen from above, counter-clockwise

  static Shape box(const Vector3& size) { return {Kind::box, size}; }
  static Shape sphere(double radius) {
    return {Kind::sphere, {2.0 * radius, 2.0 * radius, 2.0 * radius}};
  }
  /// A cylinder that stands upright.
  static Shape pillar(double radius, double height) {
    return {Kind::cylinder, {2.0 * radius, 2.0 * radius, height}};
  }
  /// A cylinder about the left axis.
  static Shape wheel(double radius, double width) {
    return {Kind::cylinder, {2.0 * radius, width, 2.0 * radius}, Axis::left};
  }
  /// A cylinder with half a ball on each end; `length` includes both, at least twice the radius.
  static Shape capsule(double radius, double length, Axis axis = Axis::up) {
    const double across = 2.0 * radius;
    return {Kind::capsule,
            {axis == Axis::forward ? length : across, axis == Axis::left ? length : across,
             axis == Axis::up ? length : across},
            axis};
  }
  /// An upright prism over a convex outline around the origin.
  static Shape prism(std::vector<Vector2> outline, double height);

  bool has_corners() const { return kind == Kind::box || kind == Kind::prism; }
  /// Returns whether it is a disc seen from above: a ball, or an upright cylinder or capsule.
  bool is_round() const { return !has_corners() && axis == Axis::up; }
  bool has_level_top() const {
    return has_corners() || (kind == Kind::cylinder && axis == Axis::up);
  }

  /// The radius of a cylinder, capsule or sphere.
  double radius() const { return 0.5 * (axis == Axis::forward ? size.y : size.x); }
  /// The length of a cylinder, or of a capsule with its caps, along its axis.
  double length() const {
    return axis == Axis::forward ? size.x : axis == Axis::left ? size.y : size.z;
  }

  friend bool operator==(const Shape&, const Shape&) = default;
};

/// The frame of a cylinder or capsule, turned so that its axis is `up`.
Frame along_axis(const Frame& frame, Shape::Axis axis);

/// Whether the lengths are finite, positive, and fit the kind.
bool is_sound(const Shape& shape);

/// A box, a prism, an upright cylinder or a ball, with the frame of its middle.
struct Piece {
  Shape shape;
  Frame frame;
};
/// The pieces of which a shape consists: what draws them needs to know no others.
std::vector<Piece> pieces_of(const Shape& shape, const Frame& middle);

/// The corners seen from above, counter-clockwise, in its frame: as many as `sides` of a disc, and
/// those of the bounding box of a shape that lies.
std::vector<Vector2> outline_of(const Shape& shape, int sides);

/// The shape with another length and width. One that is round stays so, and takes the value that
/// differs more.
Shape resized(const Shape& shape, double length, double width);

/// The moments of inertia about the axes of its frame, kg m2. A prism may have products of inertia,
/// too: moments_of().
Vector3 inertia_of(const Shape& shape, double mass);
/// The moment of inertia about the vertical axis, kg m2. The same as that of inertia_of() but for
/// rounding; runs depend on the last digit of both.
double upright_inertia_of(const Shape& shape, double mass);
/// The square of the radius of gyration about the vertical axis, m2.
double spread_of(const Shape& shape);

}  // namespace elsie
