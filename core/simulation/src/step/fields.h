// The fields of a running world.
//
// A cell holds an amount in units/m2: it is that of its whole area. What all cells hold together
// changes by deposits and evaporation only, since nothing leaves through the edges of the arena.
//
// Evaporation is exact: after half_life, half is left, whatever the steps. It multiplies all cells
// by one number, which is kept apart until it is small.
//
// Spreading is a diffusion du/dt = D (d2u/dx2 + d2u/dy2). It advances by implicit Euler steps along
// one axis after the other (locally one-dimensional: Yanenko, 1971), which are stable and never
// negative for any D and step. The matrix I - D dt L of a step keeps the sum and the middle of what
// is there, and adds exactly 2 D dt to its variance along the axis, as the diffusion itself does.
// What a long step gets wrong is the shape of a spot, whose tails are then too heavy.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/base/fnv1a.h"
#include "elsie/world/fields.h"

namespace elsie::simulation {

class RunningField {
 public:
  RunningField(const world::ScalarField& field, const world::Arena& arena);
  /// A field that an edit has changed. It keeps the values if its cells are the same.
  RunningField(const world::ScalarField& field, const world::Arena& arena,
               const RunningField& before);

  const std::string& id() const { return id_; }
  const world::FieldCells& cells() const { return cells_; }
  /// Rows from south to north; times scale(), units/m2.
  std::span<const double> grid() const { return grid_; }
  double scale() const { return scale_; }

  /// Bilinear between the middles of cells.
  double value(const Vector2& place) const;
  /// All of it goes to the cell that the place is in, or that is nearest to it; no less than
  /// nothing is left there.
  void deposit(const Vector2& place, double amount);
  /// It spreads only in some of the calls, when enough time has passed since the last one.
  void advance(double seconds);

 private:
  /// An Euler step of this length along x and along y.
  void spread(double seconds);
  void apply_scale();

  std::string id_;
  world::FieldCells cells_;
  Vector2 half_size_;      // m, of the arena
  double decay_ = 0.0;     // half-lives in a second
  double spread_ = 0.0;    // m2/s
  double unspread_ = 0.0;  // s since it has spread last
  double scale_ = 1.0;
  std::vector<double> grid_;
};

/// All fields of a world, in its order.
class Fields {
 public:
  explicit Fields(const world::World& world) : Fields(world, Fields()) {}
  /// The fields of a world that was edited; those of the same names were in it before.
  Fields(const world::World& world, const Fields& before);

  std::size_t size() const { return fields_.size(); }
  RunningField& operator[](std::size_t index) { return fields_[index]; }
  const RunningField& operator[](std::size_t index) const { return fields_[index]; }
  /// Throws base::Error with the names that there are.
  std::size_t index(std::string_view id) const;
  void advance(double seconds) {
    for (RunningField& field : fields_) field.advance(seconds);
  }
  void add_to(base::Fnv1a& hash) const;

 private:
  Fields() = default;

  std::vector<RunningField> fields_;
};

}  // namespace elsie::simulation
