#include "scene/floor_fields.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "elsie/files/base64.h"

namespace elsie::desktop {
namespace {

/// A field as the engine sends it.
struct Layer {
  Colour colour;
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> opacity;  // of 255; rows from south to north
};

std::vector<Layer> layers_of(const Json& fields) {
  std::vector<Layer> layers;
  for (const Json& each : fields) {
    const Json& colour = each.at("colour");
    Layer layer{{colour.at(0).get<std::uint8_t>(), colour.at(1).get<std::uint8_t>(),
                 colour.at(2).get<std::uint8_t>()},
                each.at("columns").get<int>(),
                each.at("rows").get<int>(),
                {}};
    auto opacity = files::unpacked<std::uint8_t>(text_of(each, "opacity").toStdString());
    const auto cells =
        static_cast<std::size_t>(layer.columns) * static_cast<std::size_t>(layer.rows);
    if (!opacity || cells == 0 || opacity->size() != cells) continue;
    layer.opacity = std::move(*opacity);
    layers.push_back(std::move(layer));
  }
  return layers;
}

/// The index, of `count`, of a part in [0, 1).
int index_of(double part, int count) {
  return std::clamp(static_cast<int>(part * count), 0, count - 1);
}

constexpr int kLeast = 512;  // pixels of a side of an image, so that what is below a field is seen

/// The colour of the floor at a part of the way from west to east and from north to south.
Colour colour_at(const render::FloorImage& below, const Colour& floor, const Vector2& arena,
                 double east, double north) {
  if (!below.pixels) return floor;
  const double x = (east - 0.5) * arena.x / below.size.x + 0.5;
  const double y = (north - 0.5) * arena.y / below.size.y + 0.5;
  if (x < 0.0 || x >= 1.0 || y < 0.0 || y >= 1.0) return floor;
  const std::uint8_t* const pixel =
      below.pixels->pixel(index_of(x, below.pixels->width), index_of(y, below.pixels->height));
  return {pixel[0], pixel[1], pixel[2]};
}

/// Whether a convex outline, counter-clockwise, is around a place.
bool is_inside(const std::vector<Vector2>& outline, const Vector2& at) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((b.x - a.x) * (at.y - a.y) < (b.y - a.y) * (at.x - a.x)) return false;
  }
  return true;
}

}  // namespace

render::FloorImage with_patches(const render::FloorImage& below, const Colour& floor,
                                const Vector2& arena,
                                const std::vector<render::FlatPatch>& patches) {
  if (patches.empty()) return below;
  auto image = std::make_shared<Image>(Image{kLeast, kLeast, 3, {}});
  image->bytes.reserve(std::size_t{3} * kLeast * kLeast);
  const auto part = [](int index) { return (index + 0.5) / kLeast; };
  for (int row = 0; row < kLeast; ++row) {
    for (int column = 0; column < kLeast; ++column) {
      const Colour colour = colour_at(below, floor, arena, part(column), part(row));
      image->bytes.insert(image->bytes.end(), {colour.red, colour.green, colour.blue});
    }
  }
  for (const render::FlatPatch& patch : patches) {
    const auto [west, east] = std::minmax_element(patch.outline.begin(), patch.outline.end(),
                                                  [](auto& a, auto& b) { return a.x < b.x; });
    const auto [south, north] = std::minmax_element(patch.outline.begin(), patch.outline.end(),
                                                    [](auto& a, auto& b) { return a.y < b.y; });
    const int first = index_of(0.5 + west->x / arena.x, kLeast);
    const int last = index_of(0.5 + east->x / arena.x, kLeast);
    const int lowest = index_of(0.5 - south->y / arena.y, kLeast);
    for (int row = index_of(0.5 - north->y / arena.y, kLeast); row <= lowest; ++row) {
      for (int column = first; column <= last; ++column) {
        const Vector2 at{(part(column) - 0.5) * arena.x, (0.5 - part(row)) * arena.y};
        if (!is_inside(patch.outline, at)) continue;
        std::uint8_t* const pixel =
            &image->bytes[static_cast<std::size_t>(3 * (row * kLeast + column))];
        pixel[0] = patch.colour.red, pixel[1] = patch.colour.green, pixel[2] = patch.colour.blue;
      }
    }
  }
  return {arena, std::move(image)};
}

render::FloorImage with_fields(const render::FloorImage& below, const Colour& floor,
                               const Vector2& arena, const Json& fields) {
  const std::vector<Layer> layers = layers_of(fields);
  if (layers.empty()) return below;
  int columns = below.pixels ? kLeast : 1, rows = below.pixels ? kLeast : 1;
  for (const Layer& layer : layers) {
    columns = std::max(columns, layer.columns), rows = std::max(rows, layer.rows);
  }
  auto image = std::make_shared<Image>(Image{columns, rows, 3, {}});
  image->bytes.reserve(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const double north = (row + 0.5) / rows;  // of the way from the north to the south
    for (int column = 0; column < columns; ++column) {
      const double east = (column + 0.5) / columns;
      const Colour ground = colour_at(below, floor, arena, east, north);
      double colour[] = {double(ground.red), double(ground.green), double(ground.blue)};
      for (const Layer& layer : layers) {
        const int at = (layer.rows - 1 - index_of(north, layer.rows)) * layer.columns +
                       index_of(east, layer.columns);
        const double part = layer.opacity[static_cast<std::size_t>(at)] / 255.0;
        const std::uint8_t over[] = {layer.colour.red, layer.colour.green, layer.colour.blue};
        for (int i = 0; i < 3; ++i) colour[i] += part * (over[i] - colour[i]);
      }
      for (const double each : colour) {
        image->bytes.push_back(static_cast<std::uint8_t>(std::lround(each)));
      }
    }
  }
  return {arena, std::move(image)};
}

}  // namespace elsie::desktop
