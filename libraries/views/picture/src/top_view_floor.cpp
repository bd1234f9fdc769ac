// The floor with its image and patches, and the lamps above it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "elsie/picture/floor_tiles.h"
#include "elsie/world/floor.h"

#include "text.h"
#include "top_view_parts.h"

namespace elsie::picture {
namespace {

constexpr double kSun = 4.5;           // the radius of a lamp, without its rays
constexpr int kMostTiles = 600;        // of an image, in each direction
constexpr int kMostTilesInText = 128;  // of one in an SVG, which grows with them

void draw_tiles(Canvas& canvas, const Layout& layout, const std::vector<FloorTile>& tiles) {
  // Edges on whole pixels, so that no line shows between neighbours.
  const auto sharp = [&](double at) { return std::round(at * canvas.zoom()) / canvas.zoom(); };
  for (const FloorTile& tile : tiles) {
    const Vector2 from = layout.map.pixel({tile.left, tile.top});
    const Vector2 to = layout.map.pixel({tile.right, tile.bottom});
    const double x = sharp(from.x), y = sharp(from.y);
    const Ink look = ink(tile.colour);
    canvas.rectangle({x, y, sharp(to.x) - x, sharp(to.y) - y})
        .fill(tile.opacity < 255 ? look.with_alpha(tile.opacity / 255.0) : look);
  }
}

void draw_patch(Canvas& canvas, const Layout& layout, const world::Patch& patch) {
  const double scale = layout.map.scale_x;
  if (patch.shape == world::PatchShape::line) {
    std::vector<Vector2> way;
    for (const Vector2& point : world::points_of_line(patch)) {
      way.push_back(layout.map.pixel(point));
    }
    canvas.polyline(way).stroke(ink(patch.colour),
                                {.width = std::max(1.0, patch.line_width * scale), .round = true});
    return;
  }
  for (const world::FloorPiece& piece : world::pieces_of(patch)) {
    if (piece.corners.empty()) {
      canvas.circle(layout.map.pixel(piece.middle), piece.radius * scale);
    } else {
      canvas.polygon(pixels(layout.map, {}, piece.corners));
    }
    canvas.fill(ink(piece.colour));
  }
}

}  // namespace

Ink nest_edge(const world::World& world, const world::Nest& nest) {
  return nest.team.empty() ? mix(ink(nest.colour), kText, 0.35) : team_ink(world, nest.team);
}

void draw_floor_marks(Canvas& canvas, const Scene& scene, const Layout& layout) {
  const int most = canvas.is_text() ? kMostTilesInText : kMostTiles;
  draw_tiles(canvas, layout, floor_tiles(scene.world, most));
  for (const world::Nest& nest : scene.world.nests) {
    draw_patch(canvas, layout, world::patch_of(nest));
    canvas.circle(layout.map.pixel({nest.x, nest.y}), nest.radius * layout.map.scale_x);
    canvas.stroke(nest_edge(scene.world, nest), {.width = kNestEdge});
  }
  for (const world::Patch& patch : scene.world.patches) draw_patch(canvas, layout, patch);
  for (const FloorField& field : scene.fields) {
    draw_tiles(canvas, layout,
               field_tiles(field, scene.world.arena, static_cast<std::size_t>(most)));
  }
}

void draw_sun(Canvas& canvas, const Vector2& at, const Ink& light) {
  constexpr int kRays = 8;
  const Ink edge = mix(light, kText, 0.65);
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kRays;
    const Vector2 way{std::cos(angle), std::sin(angle)};
    canvas.line({at.x + 6.5 * way.x, at.y + 6.5 * way.y}, {at.x + 9.5 * way.x, at.y + 9.5 * way.y});
  }
  canvas.stroke(edge, {.width = 1.6, .round = true});
  canvas.circle(at, kSun).fill_keep(light);
  canvas.stroke(edge, {.width = 1.4});
}

void draw_lamps(Canvas& canvas, const Scene& scene, const Layout& layout) {
  for (const world::Lamp& lamp : scene.world.lamps) {
    draw_sun(canvas, layout.map.pixel({lamp.x, lamp.y}), ink(lamp.colour));
  }
  for (const DrawnRobot& robot : scene.robots) {
    for (const Light& light : robot.track.lights) {
      draw_sun(canvas, layout.map.pixel(light.place), ink(light.colour));
    }
  }
}

/// Writes the ids of lamps, or of nests.
template <class Things>
void draw_ids(Canvas& canvas, const Layout& layout, LabelPlacer& labels, const Things& things,
              double apart) {
  constexpr std::size_t kMostLabels = 120;
  if (things.size() > kMostLabels) {
    labels.leave_out(things.size());
    return;
  }
  const TextStyle style{.size = 12, .ink = kFaintText, .halo = 2.5};
  for (const auto& each : things) {
    draw_label(canvas, labels, clean_text(each.id, 16), layout.map.pixel({each.x, each.y}), apart,
               style);
  }
}

void draw_floor_labels(Canvas& canvas, const Scene& scene, const Layout& layout,
                       LabelPlacer& labels) {
  draw_ids(canvas, layout, labels, scene.world.lamps, 10.0);
  draw_ids(canvas, layout, labels, scene.world.nests, 4.0);
}

}  // namespace elsie::picture
