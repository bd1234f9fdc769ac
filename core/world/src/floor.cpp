#include "elsie/world/floor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "elsie/shapes/outline.h"
#include "elsie/world/colours.h"

namespace elsie::world {
namespace {

constexpr double kEdge = 1e-9;  // m

Pose pose_of(const Patch& patch) { return {patch.x, patch.y, radians(patch.heading_deg)}; }

std::vector<Vector2> in_world(const Pose& pose, std::vector<Vector2> points) {
  for (Vector2& point : points) point = point_of(pose, point);
  return points;
}

FloorPiece rectangle(const Pose& pose, double length, double width, const Colour& colour) {
  const double x = 0.5 * length, y = 0.5 * width;
  return {.corners = in_world(pose, {{-x, -y}, {x, -y}, {x, y}, {-x, y}}), .colour = colour};
}

FloorPiece disc(const Vector2& middle, double radius, const Colour& colour) {
  return {.middle = middle, .radius = radius, .colour = colour};
}

/// The pixel at a place; none outside of the image, whose middle is the origin.
std::optional<Colour> colour_in(const Image& image, const Vector2& size, const Vector2& place) {
  const double x = place.x / size.x + 0.5, y = 0.5 - place.y / size.y;  // 0 to 1
  if (!(x >= 0.0 && x <= 1.0 && y >= 0.0 && y <= 1.0)) return std::nullopt;
  const std::uint8_t* const pixel =
      image.pixel(std::min(static_cast<int>(x * image.width), image.width - 1),
                  std::min(static_cast<int>(y * image.height), image.height - 1));
  return Colour{pixel[0], pixel[1], pixel[2]};
}

}  // namespace

std::vector<Vector2> points_of_line(const Patch& line) {
  return in_world(pose_of(line), line.points);
}

std::vector<Vector2> outline_of(const FloorPiece& piece, int sides) {
  if (!piece.corners.empty()) return piece.corners;
  std::vector<Vector2> corners;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    corners.push_back({piece.middle.x + piece.radius * std::cos(angle),
                       piece.middle.y + piece.radius * std::sin(angle)});
  }
  return corners;
}

std::vector<FloorPiece> pieces_of(const Patch& patch) {
  const Pose pose = pose_of(patch);
  switch (patch.shape) {
    case PatchShape::rectangle:
      return {rectangle(pose, patch.length, patch.width, patch.colour)};
    case PatchShape::disc:
      return {disc({patch.x, patch.y}, patch.radius, patch.colour)};
    case PatchShape::polygon:
      return {{.corners = in_world(pose, centered_outline(patch.points)), .colour = patch.colour}};
    case PatchShape::line:
      break;
  }
  std::vector<FloorPiece> pieces;
  const std::vector<Vector2> points = points_of_line(patch);
  for (std::size_t i = 0; i < points.size(); ++i) {
    pieces.push_back(disc(points[i], 0.5 * patch.line_width, patch.colour));
    if (i == 0) continue;
    const Vector2 &a = points[i - 1], &b = points[i];
    const Pose middle{0.5 * (a.x + b.x), 0.5 * (a.y + b.y), std::atan2(b.y - a.y, b.x - a.x)};
    pieces.push_back(
        rectangle(middle, std::hypot(b.x - a.x, b.y - a.y), patch.line_width, patch.colour));
  }
  return pieces;
}

Patch patch_of(const Nest& nest) {
  Patch patch;
  patch.id = nest.id;
  patch.shape = PatchShape::disc;
  patch.x = nest.x;
  patch.y = nest.y;
  patch.radius = nest.radius;
  patch.colour = nest.colour;
  return patch;
}

std::vector<FloorPiece> patches_of(const World& world) {
  std::vector<FloorPiece> pieces;
  for (const Nest& nest : world.nests) {
    for (FloorPiece& piece : pieces_of(patch_of(nest))) pieces.push_back(std::move(piece));
  }
  for (const Patch& patch : world.patches) {
    for (FloorPiece& piece : pieces_of(patch)) pieces.push_back(std::move(piece));
  }
  return pieces;
}

Vector2 image_size(const World& world) {
  return {world.floor.image_length.value_or(world.arena.length),
          world.floor.image_width.value_or(world.arena.width)};
}

FloorMap::FloorMap(const World& world)
    : colour_(world.floor.colour.value_or(kPlainFloor)),
      half_length_(0.5 * world.arena.length),
      half_width_(0.5 * world.arena.width),
      pixels_(world.floor.pixels),
      image_size_(image_size(world)),
      grid_(world.arena.length, world.arena.width) {
  for (const FloorPiece& piece : patches_of(world)) add(piece);
  for (const Charger& charger : world.chargers) {
    if (charger.seen_by_range_sensors) continue;  // a box
    add(disc({charger.x, charger.y}, charger.radius, team_colour(world, charger.team)));
  }
}

void FloorMap::add(const FloorPiece& piece) {
  const std::vector<Vector2>& corners = piece.corners;
  const Vector2& at = piece.middle;
  double x0 = at.x - piece.radius, x1 = at.x + piece.radius;
  double y0 = at.y - piece.radius, y1 = at.y + piece.radius;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const Vector2 out{(b.y - a.y) / length, (a.x - b.x) / length};
    sides_.push_back({out, out.x * a.x + out.y * a.y});
    x0 = i == 0 ? a.x : std::min(x0, a.x), x1 = i == 0 ? a.x : std::max(x1, a.x);
    y0 = i == 0 ? a.y : std::min(y0, a.y), y1 = i == 0 ? a.y : std::max(y1, a.y);
  }
  grid_.insert(static_cast<base::Grid::Id>(pieces_.size()),
               grid_.block(x0 - kEdge, y0 - kEdge, x1 + kEdge, y1 + kEdge));
  pieces_.push_back(
      {sides_.size() - corners.size(), corners.size(), at, piece.radius, piece.colour});
}

bool FloorMap::covers(const Piece& piece, const Vector2& place) const {
  if (piece.sides == 0) {
    const double x = place.x - piece.middle.x, y = place.y - piece.middle.y;
    const double reach = piece.radius + kEdge;
    return x * x + y * y <= reach * reach;
  }
  const auto first = sides_.begin() + static_cast<std::ptrdiff_t>(piece.first);
  return std::all_of(first, first + static_cast<std::ptrdiff_t>(piece.sides),
                     [&](const Side& side) {
                       return side.out.x * place.x + side.out.y * place.y <= side.at + kEdge;
                     });
}

Colour FloorMap::colour_at(const Vector2& place) const {
  if (!(std::abs(place.x) <= half_length_ && std::abs(place.y) <= half_width_)) return colour_;
  const auto cell = grid_.cell(grid_.column(place.x), grid_.row(place.y));
  for (auto id = cell.rbegin(); id != cell.rend(); ++id) {
    if (covers(pieces_[*id], place)) return pieces_[*id].colour;
  }
  const auto pixel = pixels_ ? colour_in(*pixels_, image_size_, place) : std::nullopt;
  return pixel.value_or(colour_);
}

}  // namespace elsie::world
