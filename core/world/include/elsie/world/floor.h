// The floor of a world: the shapes of its patches, and its colour at any place.
//
// From below: the floor's colour, its image, nests, its patches in their order, the marks of
// chargers.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/base/grid.h"
#include "elsie/world/description.h"

namespace elsie::world {

/// The radius of the ball as which a lamp is drawn, m.
inline constexpr double kLampRadius = 0.03;

/// The colour that sensors see on a floor without one. Pictures and cameras show it their own way.
inline constexpr Colour kPlainFloor{255, 255, 255};

/// A part of a patch: a convex polygon or, without corners, a disc.
struct FloorPiece {
  std::vector<Vector2> corners{};  // m, in the world, counter-clockwise
  Vector2 middle{};                // m, of a disc
  double radius = 0.0;             // m
  Colour colour{};
};

/// The pieces of a patch, which may overlap: a line has one for each of its points and sections.
std::vector<FloorPiece> pieces_of(const Patch& patch);
/// The corners of a piece, counter-clockwise: as many as `sides` of a disc.
std::vector<Vector2> outline_of(const FloorPiece& piece, int sides);
/// The points of a line in the world, m.
std::vector<Vector2> points_of_line(const Patch& line);
/// The disc of a nest, as a patch.
Patch patch_of(const Nest& nest);
/// The pieces of all nests and patches, the lowest first.
std::vector<FloorPiece> patches_of(const World& world);

/// The length and width of the floor's image, m.
Vector2 image_size(const World& world);

/// Answers what colour the floor has at a place, fast however many patches there are. Keeps nothing
/// of the world but the pixels of the image.
class FloorMap {
 public:
  explicit FloorMap(const World& world);

  /// The colour at a place, m. Edges, to a nanometre, belong to the patch. Outside of the arena:
  /// the floor's colour.
  Colour colour_at(const Vector2& place) const;

 private:
  /// A straight edge of a piece: inside, dot(out, place) is at most `at`.
  struct Side {
    Vector2 out;
    double at = 0.0;
  };
  /// A disc, or the sides from `first` to the next piece's.
  struct Piece {
    std::size_t first = 0, sides = 0;
    Vector2 middle;
    double radius = 0.0;
    Colour colour;
  };

  void add(const FloorPiece& piece);
  bool covers(const Piece& piece, const Vector2& place) const;

  Colour colour_;
  double half_length_, half_width_;  // m, of the arena
  std::shared_ptr<const Image> pixels_;
  Vector2 image_size_;
  std::vector<Piece> pieces_;  // the lowest first
  std::vector<Side> sides_;
  base::Grid grid_;
};

}  // namespace elsie::world
