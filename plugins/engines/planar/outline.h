// Upright prisms, and where two of them meet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "elsie/api/body.h"
#include "elsie/api/geometry.h"

#include "plane.h"

namespace elsie::physics {

/// A convex polygon from above, rounded by a radius: a disc has one corner, a lying capsule two.
struct Outline {
  std::vector<Vector2> corners;    // counter-clockwise, around its middle
  std::vector<Vector2> normals;    // of the edge from each corner to the next one, outwards
  double radius = 0.0;             // m
  double bottom = 0.0, top = 0.0;  // m, above the floor
  double reach = 0.0;              // m, the largest distance of any of its points from its middle
  Vector2 half;                    // m, of the box around it, along either axis of its frame

  static Outline polygon(std::vector<Vector2> corners, double radius, double bottom, double top);
  static Outline rectangle(double half_length, double half_width, double bottom, double top);
  static Outline disc(double radius, double bottom, double top);
  /// A solid whose frame is upright; its middle is at this height.
  static Outline of(const Shape& shape, double height);

  bool is_level_with(const Outline& other) const {
    return bottom < other.top && other.bottom < top;
  }
};

/// An outline at a place.
struct PlacedOutline {
  std::span<const Vector2> corners, normals;  // in the world
  double radius = 0.0;
};

/// False if two outlines are certainly further apart than `margin`: by the rectangles around them.
/// `away`: from the middle of `b` to that of `a`.
bool may_meet(const Outline& a, const Direction& ahead_a, const Outline& b,
              const Direction& ahead_b, const Vector2& away, double margin);

/// The corners of an outline in the world; `space` keeps them.
PlacedOutline placed(const Outline& outline, const Vector2& middle, const Direction& ahead,
                     std::vector<Vector2>& space);

/// Where two outlines meet or come near each other.
struct Meeting {
  struct Point {
    Vector2 at;                 // half way between the surfaces
    double gap = 0.0;           // m; negative if they overlap
    std::uint32_t feature = 0;  // which corners and edges: the same as long as they meet alike
  };
  Vector2 normal;  // from the second into the first
  std::array<Point, 2> points;
  std::size_t count = 0;
};

/// The points at which they are no further apart than `margin`, by separating axes and clipping
/// (Gottschalk, Lin and Manocha 1996; Catto, "Contact manifolds", 2007).
Meeting meet(const PlacedOutline& a, const PlacedOutline& b, double margin);

}  // namespace elsie::physics
