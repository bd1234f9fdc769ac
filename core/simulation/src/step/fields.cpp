#include "step/fields.h"

#include <algorithm>
#include <cmath>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"

namespace elsie::simulation {
namespace {

constexpr double kSpreadEvery = 0.1;  // s: more often would cost time, and change little
/// Less than this is nothing: far from a spot, numbers would become so small that processors
/// calculate slowly with them.
constexpr double kNothing = 1e-100;

/// A coordinate in cells, kept within 0 and `most`.
double within(double at, double most) { return std::max(0.0, std::min(most, at)); }

double or_nothing(double value) { return value < kNothing ? 0.0 : value; }

/// The elimination for (1 + r n) u[i] - r (u of its n neighbours) = known, on a line of cells.
struct Elimination {
  std::vector<double> pivots, ratios;

  Elimination(std::size_t cells, double r) : pivots(cells), ratios(cells) {
    double ratio = 0.0;
    for (std::size_t i = 0; i < cells; ++i) {
      const double neighbours = (i > 0 ? 1.0 : 0.0) + (i + 1 < cells ? 1.0 : 0.0);
      pivots[i] = 1.0 / (1.0 + r * neighbours - r * ratio);
      ratio = ratios[i] = i + 1 < cells ? r * pivots[i] : 0.0;
    }
  }
};

}  // namespace

RunningField::RunningField(const world::ScalarField& field, const world::Arena& arena)
    : id_(field.id),
      cells_(world::cells_of(field, arena)),
      half_size_{0.5 * arena.length, 0.5 * arena.width},
      decay_(field.half_life ? 1.0 / *field.half_life : 0.0),
      spread_(field.spread),
      grid_(cells_.count(), field.start) {}

RunningField::RunningField(const world::ScalarField& field, const world::Arena& arena,
                           const RunningField& before)
    : RunningField(field, arena) {
  if (cells_ != before.cells_) return;
  unspread_ = before.unspread_;
  scale_ = before.scale_;
  grid_ = before.grid_;
}

double RunningField::value(const Vector2& place) const {
  struct Between {
    std::size_t low, high;
    double part;
  };
  const auto between = [](double at, std::size_t cells) -> Between {
    const double inside = within(at - 0.5, static_cast<double>(cells - 1));
    const auto low = static_cast<std::size_t>(inside);
    return {low, std::min(low + 1, cells - 1), inside - static_cast<double>(low)};
  };
  const Between x = between((place.x + half_size_.x) / cells_.length, cells_.columns);
  const Between y = between((place.y + half_size_.y) / cells_.width, cells_.rows);
  const auto along = [&](std::size_t row) {
    const double* const first = &grid_[row * cells_.columns];
    return (1.0 - x.part) * first[x.low] + x.part * first[x.high];
  };
  return scale_ * ((1.0 - y.part) * along(y.low) + y.part * along(y.high));
}

void RunningField::deposit(const Vector2& place, double amount) {
  const auto cell = [](double at, std::size_t cells) {
    return static_cast<std::size_t>(within(at, static_cast<double>(cells - 1)));
  };
  double& there =
      grid_[cell((place.y + half_size_.y) / cells_.width, cells_.rows) * cells_.columns +
            cell((place.x + half_size_.x) / cells_.length, cells_.columns)];
  there = std::max(0.0, there + amount / (cells_.area() * scale_));
}

void RunningField::advance(double seconds) {
  constexpr double kSmall = 1e-20;
  constexpr double kRounding = 1e-9;  // s
  if (decay_ > 0.0) {
    scale_ *= std::exp2(-seconds * decay_);
    if (scale_ < kSmall) apply_scale();
  }
  if (!(spread_ > 0.0)) return;
  unspread_ += seconds;
  if (unspread_ < kSpreadEvery - kRounding) return;
  spread(unspread_);
  unspread_ = 0.0;
}

void RunningField::apply_scale() {
  for (double& each : grid_) each = or_nothing(scale_ * each);
  scale_ = 1.0;
}

void RunningField::spread(double seconds) {
  const std::size_t columns = cells_.columns, rows = cells_.rows;
  const double along_x = spread_ * seconds / (cells_.length * cells_.length);
  const double along_y = spread_ * seconds / (cells_.width * cells_.width);
  const Elimination x(columns, along_x), y(rows, along_y);
  for (std::size_t row = 0; row < rows; ++row) {
    double* const u = &grid_[row * columns];
    double before = 0.0;
    for (std::size_t i = 0; i < columns; ++i) {
      before = u[i] = or_nothing((u[i] + along_x * before) * x.pivots[i]);
    }
    for (std::size_t i = columns - 1; i-- > 0;) u[i] = or_nothing(u[i] + x.ratios[i] * u[i + 1]);
  }
  // Whole rows at once, which compilers turn into vector instructions.
  for (std::size_t row = 0; row < rows; ++row) {
    double* const u = &grid_[row * columns];
    const double* const before = row > 0 ? u - columns : u;
    const double r = row > 0 ? along_y : 0.0, pivot = y.pivots[row];
    for (std::size_t i = 0; i < columns; ++i) u[i] = or_nothing((u[i] + r * before[i]) * pivot);
  }
  for (std::size_t row = rows - 1; row-- > 0;) {
    double* const u = &grid_[row * columns];
    const double* const above = u + columns;
    const double ratio = y.ratios[row];
    for (std::size_t i = 0; i < columns; ++i) u[i] = or_nothing(u[i] + ratio * above[i]);
  }
}

Fields::Fields(const world::World& world, const Fields& before) {
  fields_.reserve(world.fields.size());
  for (const world::ScalarField& field : world.fields) {
    const auto known = std::find_if(before.fields_.begin(), before.fields_.end(),
                                    [&](const auto& each) { return each.id() == field.id; });
    if (known == before.fields_.end()) {
      fields_.emplace_back(field, world.arena);
    } else {
      fields_.emplace_back(field, world.arena, *known);
    }
  }
}

std::size_t Fields::index(std::string_view id) const {
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    if (fields_[i].id() == id) return i;
  }
  std::vector<std::string> ids;
  for (const RunningField& field : fields_) ids.push_back(field.id());
  throw base::Error("it names the field '" + std::string(id) + "', which the world does not have" +
                    base::near_or_all(std::string(id), ids, "it has"));
}

void Fields::add_to(base::Fnv1a& hash) const {
  for (const RunningField& field : fields_) {
    for (const double each : field.grid()) hash.add(field.scale() * each);
  }
}

}  // namespace elsie::simulation
