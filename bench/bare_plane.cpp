#include "bare_plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace elsie::bench {
namespace {

constexpr double kCell = 1.0;  // m

}  // namespace

BarePlane::BarePlane(std::span<const Pose> poses, std::span<const world::Obstacle> boxes,
                     const world::Physics& physics, const world::Arena& arena)
    : half_(0.5 * arena.length),
      columns_(static_cast<int>(std::ceil(arena.length / kCell)) + 2),
      step_(physics.step) {
  const world::RobotBody body;
  wheel_radius_ = body.wheel_radius;
  half_axle_ = body.half_axle();
  radius_ = std::sqrt(body.length * body.width / M_PI);
  front_ = 0.5 * body.length;
  for (const double azimuth : kBeamAzimuths_deg) {
    beams_.push_back({std::cos(radians(azimuth)), std::sin(radians(azimuth))});
  }
  const auto cells = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(columns_);
  blocks_in_.resize(cells);
  first_.resize(cells + 1);
  for (const world::Obstacle& box : boxes) {
    const double heading = radians(box.heading_deg), c = std::cos(heading), s = std::sin(heading);
    const Point half{0.5 * box.length, 0.5 * box.width};
    const double x = std::abs(c) * half.x + std::abs(s) * half.y;
    const double y = std::abs(s) * half.x + std::abs(c) * half.y;
    for (int row = column(box.y - y); row <= column(box.y + y); ++row) {
      for (int place = column(box.x - x); place <= column(box.x + x); ++place) {
        blocks_in_[static_cast<std::size_t>(row * columns_ + place)].push_back(blocks_.size());
      }
    }
    blocks_.push_back({{box.x, box.y}, {c, s}, half});
  }
  for (const Pose& pose : poses) {
    discs_.push_back({{pose.x, pose.y}, {std::cos(pose.heading_rad), std::sin(pose.heading_rad)}});
  }
  sorted_.resize(discs_.size());
}

Pose BarePlane::pose(std::size_t robot) const {
  const Disc& disc = discs_[robot];
  return {disc.at.x, disc.at.y, std::atan2(disc.ahead.y, disc.ahead.x)};
}

int BarePlane::column(double place) const {
  return std::clamp(static_cast<int>((place + half_) / kCell) + 1, 0, columns_ - 1);
}

void BarePlane::sort_into_cells() {
  std::fill(first_.begin(), first_.end(), 0);
  for (Disc& disc : discs_) {
    disc.cell = static_cast<std::size_t>(column(disc.at.y) * columns_ + column(disc.at.x));
    ++first_[disc.cell + 1];
  }
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  next_.assign(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < discs_.size(); ++i) sorted_[next_[discs_[i].cell]++] = i;
}

/// Visits the cells around a disc.
template <class Visit>
void BarePlane::near(const Disc& disc, const Visit& visit) const {
  const int x = column(disc.at.x), y = column(disc.at.y);
  for (int row = std::max(0, y - 1); row <= std::min(columns_ - 1, y + 1); ++row) {
    for (int place = std::max(0, x - 1); place <= std::min(columns_ - 1, x + 1); ++place) {
      visit(static_cast<std::size_t>(row * columns_ + place));
    }
  }
}

double BarePlane::distance_to(const Block& block, const Point& from, const Point& along) {
  const double dx = from.x - block.at.x, dy = from.y - block.at.y;
  const Point at{dx * block.ahead.x + dy * block.ahead.y, dy * block.ahead.x - dx * block.ahead.y};
  const Point by{along.x * block.ahead.x + along.y * block.ahead.y,
                 along.y * block.ahead.x - along.x * block.ahead.y};
  const double x0 = (-block.half.x - at.x) / by.x, x1 = (block.half.x - at.x) / by.x;
  const double y0 = (-block.half.y - at.y) / by.y, y1 = (block.half.y - at.y) / by.y;
  const double enter = std::max(std::min(x0, x1), std::min(y0, y1));
  const double leave = std::min(std::max(x0, x1), std::max(y0, y1));
  return leave >= enter && leave > 0.0 ? std::max(0.0, enter) : kBeamRange_m;
}

void BarePlane::steer_by_beams(Disc& disc) {
  constexpr std::size_t kMost = 64;
  std::array<const Block*, kMost> blocks;
  std::array<const Disc*, kMost> discs;
  std::size_t block_count = 0, disc_count = 0;
  const Point from{disc.at.x + front_ * disc.ahead.x, disc.at.y + front_ * disc.ahead.y};
  near(disc, [&](std::size_t cell) {
    for (const std::size_t i : blocks_in_[cell]) {
      const auto end = blocks.begin() + block_count;
      if (block_count < kMost && std::find(blocks.begin(), end, &blocks_[i]) == end) {
        blocks[block_count++] = &blocks_[i];
      }
    }
    for (std::size_t k = first_[cell]; k < first_[cell + 1]; ++k) {
      const Disc& other = discs_[sorted_[k]];
      const double dx = other.at.x - from.x, dy = other.at.y - from.y;
      const double reach = kBeamRange_m + radius_;
      if (&other != &disc && disc_count < kMost && dx * dx + dy * dy < reach * reach) {
        discs[disc_count++] = &other;
      }
    }
  });
  std::array<double, kBeamAzimuths_deg.size()> ranges;
  for (std::size_t b = 0; b < beams_.size(); ++b) {
    const Point along{disc.ahead.x * beams_[b].x - disc.ahead.y * beams_[b].y,
                      disc.ahead.y * beams_[b].x + disc.ahead.x * beams_[b].y};
    double nearest = std::min({kBeamRange_m, ((along.x > 0 ? half_ : -half_) - from.x) / along.x,
                               ((along.y > 0 ? half_ : -half_) - from.y) / along.y});
    for (std::size_t i = 0; i < block_count; ++i) {
      nearest = std::min(nearest, distance_to(*blocks[i], from, along));
    }
    for (std::size_t i = 0; i < disc_count; ++i) {
      const double dx = discs[i]->at.x - from.x, dy = discs[i]->at.y - from.y;
      const double past = dx * along.x + dy * along.y, off = dx * dx + dy * dy - past * past;
      if (past > 0.0 && off < radius_ * radius_) {
        nearest = std::min(nearest, past - std::sqrt(radius_ * radius_ - off));
      }
    }
    ranges[b] = std::max(0.0, nearest);
  }
  const WheelRates rates = steer(ranges.data());
  disc.left = rates.left;
  disc.right = rates.right;
}

void BarePlane::drive(Disc& disc) const {
  const double left = wheel_radius_ * disc.left, right = wheel_radius_ * disc.right;
  const double half_turn = 0.25 * step_ * (right - left) / half_axle_;
  const double s = std::sin(half_turn), c = std::cos(half_turn);
  // The chord of the arc.
  const double chord = 0.5 * step_ * (left + right) * (half_turn == 0.0 ? 1.0 : s / half_turn);
  disc.at.x += chord * (disc.ahead.x * c - disc.ahead.y * s);
  disc.at.y += chord * (disc.ahead.y * c + disc.ahead.x * s);
  const double s2 = 2.0 * s * c, c2 = 1.0 - 2.0 * s * s;
  const Point ahead{disc.ahead.x * c2 - disc.ahead.y * s2, disc.ahead.y * c2 + disc.ahead.x * s2};
  const double length = std::hypot(ahead.x, ahead.y);
  disc.ahead = {ahead.x / length, ahead.y / length};
}

void BarePlane::part(Disc& disc) {
  const double most = half_ - radius_;
  disc.at = {std::clamp(disc.at.x, -most, most), std::clamp(disc.at.y, -most, most)};
  const auto cell = static_cast<std::size_t>(column(disc.at.y) * columns_ + column(disc.at.x));
  for (const std::size_t i : blocks_in_[cell]) {
    const Block& block = blocks_[i];
    const double dx = disc.at.x - block.at.x, dy = disc.at.y - block.at.y;
    const Point at{dx * block.ahead.x + dy * block.ahead.y,
                   dy * block.ahead.x - dx * block.ahead.y};
    const Point out{at.x - std::clamp(at.x, -block.half.x, block.half.x),
                    at.y - std::clamp(at.y, -block.half.y, block.half.y)};
    const double away = std::hypot(out.x, out.y);
    if (away <= 0.0 || away >= radius_) continue;
    const double by = (radius_ - away) / away;
    disc.at.x += by * (out.x * block.ahead.x - out.y * block.ahead.y);
    disc.at.y += by * (out.y * block.ahead.x + out.x * block.ahead.y);
  }
  near(disc, [&](std::size_t place) {
    for (std::size_t k = first_[place]; k < first_[place + 1]; ++k) {
      Disc& other = discs_[sorted_[k]];
      if (&other <= &disc) continue;
      const double dx = other.at.x - disc.at.x, dy = other.at.y - disc.at.y;
      const double square = dx * dx + dy * dy;
      if (square <= 0.0 || square >= 4.0 * radius_ * radius_) continue;
      const double away = std::sqrt(square), by = 0.5 * (2.0 * radius_ - away) / away;
      disc.at = {disc.at.x - by * dx, disc.at.y - by * dy};
      other.at = {other.at.x + by * dx, other.at.y + by * dy};
    }
  });
}

void BarePlane::step() {
  sort_into_cells();
  for (Disc& disc : discs_) steer_by_beams(disc);
  for (Disc& disc : discs_) drive(disc);
  for (Disc& disc : discs_) part(disc);
}

}  // namespace elsie::bench
