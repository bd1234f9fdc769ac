// Rays from one point, as those of a lidar: each body around the point is looked up once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <span>
#include <vector>

#include "ray_cast.h"

namespace elsie::physics {

/// Casts rays from one point. Whatever the order of the bodies, a ray meets the nearest one, so
/// that the answers are those of cast().
///
///   sectors   the directions around the point, seen from above, are divided into kSectors, and the
///             rays are sorted into them
///   rings     the grid's cells are visited in squares around the point, from the inside outwards,
///             until no ray reaches further
///   bodies    each is tested against the rays in the sectors of the rectangle around it
///
/// With n rays and m bodies around them, rays that do not meet a body cost nothing: about n + m
/// tests instead of the n times sqrt(m) cells of single rays.
template <class View>
class RayFan {
 public:
  static constexpr std::size_t kMost = 512;  // rays; more would leave the processor's cache

  RayFan(const View& view, const Vector3& origin)
      : view_(view), origin_(origin), column_(view.grid().column(origin.x)),
        row_(view.grid().row(origin.y)) {}

  /// All rays start at the origin, in the world; they are at most kMost.
  void cast(const Frame& within, std::span<RayQuery> queries, std::span<Surface> surfaces) {
    beams_.reserve(queries.size());
    for (const RayQuery& query : queries) {
      add(within.direction(query.from->forward), query.max_range_m);
    }
    sort();
    visit_rings();
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const Beam& beam = beams_[i];
      queries[i].distance_m = answer_of(beam.nearest);
      if (!surfaces.empty()) surfaces[i] = surface_of(view_, beam.nearest, beam.ray);
    }
  }

 private:
  static constexpr int kSectors = 1024;
  static constexpr double kNarrow = 1e-9;  // of a right angle: more than rounding

  struct Beam {
    explicit Beam(const Ray& with) : ray(with) {}
    Ray ray;
    Nearest nearest;
    int sector = -1;
  };

  /// The direction of a vector, from 0 to 4, growing counter-clockwise as its angle does.
  static double turn_of(double x, double y) {
    const double part = y / (std::abs(x) + std::abs(y));
    return x < 0.0 ? 2.0 - part : y < 0.0 ? 4.0 + part : part;
  }
  static int sector_of(double turn) {
    const double around = turn < 0.0 ? turn + 4.0 : turn >= 4.0 ? turn - 4.0 : turn;
    return std::clamp(static_cast<int>(around * (0.25 * kSectors)), 0, kSectors - 1);
  }

  void add(const Vector3& along, double max_range) {
    Beam& beam = beams_.emplace_back(Ray(origin_, along));
    beam.nearest.distance = max_range;
    if (!is_finite(beam.ray)) return;
    if (std::abs(along.x) + std::abs(along.y) < kNarrow) {
      // Straight up or down.
      beam.nearest = physics::cast(view_, beam.ray, max_range);
      return;
    }
    beam.nearest.meet_floor(beam.ray);
    farthest_ = std::max(farthest_, beam.nearest.distance);
    beam.sector = sector_of(turn_of(along.x, along.y));
    ++firsts_[static_cast<std::size_t>(beam.sector) + 1];
  }

  /// By counting.
  void sort() {
    std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
    sorted_.resize(firsts_.back());
    std::array<std::uint32_t, kSectors + 1> next = firsts_;
    for (std::uint32_t i = 0; i < beams_.size(); ++i) {
      const int sector = beams_[i].sector;
      if (sector >= 0) sorted_[next[static_cast<std::size_t>(sector)]++] = i;
    }
  }

  void visit_rings() {
    const base::Grid& grid = view_.grid();
    const int last = std::max({column_, grid.columns() - 1 - column_, row_,
                               grid.rows() - 1 - row_});
    std::size_t done = 0;  // beams that reach no further ring
    for (int ring = 0; ring <= last; ++ring) {
      const double way = ring > 0 ? way_to(ring) : 0.0;
      const auto is_done = [&](const Beam& beam) {
        return beam.sector < 0 || beam.nearest.distance <= way;
      };
      while (done < beams_.size() && is_done(beams_[done])) ++done;
      if (done == beams_.size()) return;
      visit(ring);
    }
  }

  /// How far it is to the cells of a ring, m. Cells at the border of the grid reach to infinity.
  double way_to(int ring) const {
    const base::Grid& grid = view_.grid();
    double way = kMiss;
    if (column_ - ring >= 0) {
      way = std::min(way, origin_.x - grid.column_border(column_ - ring + 1));
    }
    if (column_ + ring < grid.columns()) {
      way = std::min(way, grid.column_border(column_ + ring) - origin_.x);
    }
    if (row_ - ring >= 0) way = std::min(way, origin_.y - grid.row_border(row_ - ring + 1));
    if (row_ + ring < grid.rows()) way = std::min(way, grid.row_border(row_ + ring) - origin_.y);
    return way;
  }

  void visit(int ring) {
    const base::Grid& grid = view_.grid();
    const int x0 = std::max(0, column_ - ring), x1 = std::min(grid.columns() - 1, column_ + ring);
    const int y0 = std::max(0, row_ - ring), y1 = std::min(grid.rows() - 1, row_ + ring);
    for (int y = y0; y <= y1; ++y) {
      const bool is_whole = std::abs(y - row_) == ring;
      for (int x = x0; x <= x1; ++x) {
        if (is_whole || std::abs(x - column_) == ring) {
          visit_cell(x, y);
        } else {
          x = std::max(x, std::min(x1, column_ + ring - 1));  // the inner rings
        }
      }
    }
  }

  /// Meets the bodies in a cell, each in the first of its cells.
  void visit_cell(int x, int y) {
    for (const base::Grid::Id id : view_.grid().cell(x, y)) {
      const base::Grid::Block block = view_.block_of(id);
      if (x == std::clamp(column_, block.x0, block.x1) &&
          y == std::clamp(row_, block.y0, block.y1) && view_.sees(id)) {
        meet(id);
      }
    }
  }

  void meet(base::Grid::Id id) {
    const auto [least, most] = view_.reach_of(id);
    const double x0 = least.x - origin_.x, x1 = most.x - origin_.x;
    const double y0 = least.y - origin_.y, y1 = most.y - origin_.y;
    const int side_x = x0 > 0.0 ? 1 : x1 < 0.0 ? -1 : 0;
    const int side_y = y0 > 0.0 ? 1 : y1 < 0.0 ? -1 : 0;
    if (side_x == 0 && side_y == 0) return meet(id, 0, kSectors - 1);
    const double away_x = side_x > 0 ? x0 : side_x < 0 ? -x1 : 0.0;
    const double away_y = side_y > 0 ? y0 : side_y < 0 ? -y1 : 0.0;
    if (away_x * away_x + away_y * away_y > farthest_ * farthest_) return;
    // The two corners between which the rectangle is seen, counter-clockwise.
    const double from_x = side_y > 0 || (side_y == 0 && side_x < 0) ? x1 : x0;
    const double from_y = side_x < 0 || (side_x == 0 && side_y < 0) ? y1 : y0;
    const double to_x = side_y < 0 || (side_y == 0 && side_x < 0) ? x1 : x0;
    const double to_y = side_x > 0 || (side_x == 0 && side_y < 0) ? y1 : y0;
    const int first = sector_of(turn_of(from_x, from_y) - kNarrow);
    const int last = sector_of(turn_of(to_x, to_y) + kNarrow);
    if (first <= last) return meet(id, first, last);
    meet(id, first, kSectors - 1);
    meet(id, 0, last);
  }

  void meet(base::Grid::Id id, int first, int last) {
    const std::uint32_t begin = firsts_[static_cast<std::size_t>(first)];
    const std::uint32_t end = firsts_[static_cast<std::size_t>(last) + 1];
    for (std::uint32_t i = begin; i < end; ++i) {
      Beam& beam = beams_[sorted_[i]];
      beam.nearest.meet(view_, id, beam.ray);
    }
  }

  const View& view_;
  Vector3 origin_;
  int column_, row_;  // its cell
  std::vector<Beam> beams_;
  std::array<std::uint32_t, kSectors + 1> firsts_{};  // in sorted_, of each sector
  std::vector<std::uint32_t> sorted_;                 // beams, by sector
  double farthest_ = 0.0;                             // m, no ray reaches further
};

/// The number of rays at the beginning that start at one point.
inline std::size_t from_one_point(std::span<const RayQuery> rays) {
  const Vector3& origin = rays.front().from->origin;
  std::size_t count = 1;
  while (count < rays.size() && rays[count].from->origin == origin) ++count;
  return count;
}

/// As Engine::cast_rays(): rays that start at one point together, if they are enough, and runs of
/// others by `cast_others(rays, surfaces)`.
template <class View, class CastOthers>
void cast_fans(const View& view, const Frame& within, std::span<RayQuery> rays,
               std::span<Surface> surfaces, std::size_t least, CastOthers cast_others) {
  const auto take = [&](std::size_t count, auto cast) {
    const auto of_them = surfaces.first(surfaces.empty() ? 0 : count);
    cast(rays.first(count), of_them);
    rays = rays.subspan(count);
    surfaces = surfaces.subspan(of_them.size());
  };
  while (!rays.empty()) {
    std::size_t others = 0, count = 0;
    while (others < rays.size()) {
      count = from_one_point(rays.subspan(others));
      if (count >= least) break;
      others += count;
      count = 0;
    }
    if (others > 0) take(others, cast_others);
    while (count > 0) {
      const Vector3 origin = within.point(rays.front().from->origin);
      const std::size_t some = std::min(count, RayFan<View>::kMost);
      take(some, [&](std::span<RayQuery> of_fan, std::span<Surface> of_them) {
        RayFan<View>(view, origin).cast(within, of_fan, of_them);
      });
      count -= some;
    }
  }
}

}  // namespace elsie::physics
