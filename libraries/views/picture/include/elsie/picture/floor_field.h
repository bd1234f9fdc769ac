// A field of a world at an instant, for pictures and recordings.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "elsie/picture/floor_tiles.h"

namespace elsie::simulation {
struct FieldView;
}

namespace elsie::picture {

/// A grid over the arena.
struct FloorField {
  std::string id;
  Colour colour;
  std::optional<double> full;  // as world::ScalarField::full
  std::size_t columns = 0, rows = 0;
  std::vector<float> values;  // units/m2; rows from south to north, each from west to east

  /// The value that is shown in the full colour; 0: there is nothing to show.
  double solid() const;
  /// How opaque each cell is, of 255.
  std::vector<std::uint8_t> opacities() const;
};

/// The field in at most `most` columns and rows: one that has more is shown by means of its cells.
FloorField floor_field(const simulation::FieldView& field, std::size_t most);

/// The field as rectangles, whose opacity is proportional to its values, in shades, in at most
/// `most` columns and rows: one that has more is sampled. Where it is next to nothing there is
/// none.
std::vector<FloorTile> field_tiles(const FloorField& field, const world::Arena& arena,
                                   std::size_t most);

}  // namespace elsie::picture
