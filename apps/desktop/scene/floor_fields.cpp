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

}  // namespace

render::FloorImage with_fields(const render::FloorImage& below, const Colour& floor,
                               const Vector2& arena, const Json& fields) {
  constexpr int kLeast = 512;  // with an image below, whose pixels should be seen
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
      double colour[] = {double(floor.red), double(floor.green), double(floor.blue)};
      if (below.pixels) {
        const double x = (east - 0.5) * arena.x / below.size.x + 0.5;
        const double y = (north - 0.5) * arena.y / below.size.y + 0.5;
        if (x >= 0.0 && x < 1.0 && y >= 0.0 && y < 1.0) {
          const std::uint8_t* const pixel = below.pixels->pixel(index_of(x, below.pixels->width),
                                                                index_of(y, below.pixels->height));
          std::copy(pixel, pixel + 3, colour);
        }
      }
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
