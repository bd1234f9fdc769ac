// The grids of fields.
#pragma once

#include <cstddef>

#include "elsie/world/description.h"

namespace elsie::world {

/// The cells of a field, which divide the arena evenly, from its south-west corner.
struct FieldCells {
  std::size_t columns = 1, rows = 1;
  double length = 0.0, width = 0.0;  // m, of a cell, along x and y

  std::size_t count() const { return columns * rows; }
  double area() const { return length * width; }  // m2, of a cell
  friend bool operator==(const FieldCells&, const FieldCells&) = default;
};

/// A field with more is refused: it would need some 30 MB, and be slower than real time.
inline constexpr std::size_t kMostFieldCells = 4'000'000;

/// As few cells as have edges of at most ScalarField::cell.
FieldCells cells_of(const ScalarField& field, const Arena& arena);

}  // namespace elsie::world
