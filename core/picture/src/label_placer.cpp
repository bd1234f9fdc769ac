#include "label_placer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace elsie::picture {
namespace {

constexpr double kCell = 4.0;
constexpr double kSpotWeight = 3.0;  // against units of area of an obstacle of weight 1
constexpr double kOutsideWeight = 20.0;
constexpr double kFarWeight = 1.5;  // for each unit of distance

double overlap(const Rect& a, const Rect& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0.0;
}

}  // namespace

LabelPlacer::LabelPlacer(const Rect& frame)
    : frame_(frame),
      columns_(static_cast<std::size_t>(std::max(1.0, std::ceil(frame.width / kCell)))),
      rows_(static_cast<std::size_t>(std::max(1.0, std::ceil(frame.height / kCell)))),
      spots_(columns_ * rows_, 0) {}

void LabelPlacer::avoid(const Rect& rect, double weight) { obstacles_.push_back({rect, weight}); }

void LabelPlacer::avoid_spot(const Vector2& spot) {
  const double column = std::floor((spot.x - frame_.x) / kCell);
  const double row = std::floor((spot.y - frame_.y) / kCell);
  if (!(column >= 0 && row >= 0)) return;
  if (column >= static_cast<double>(columns_) || row >= static_cast<double>(rows_)) return;
  int& count = spots_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
  count = std::min(count + 1, 3);  // more ink on ink hides no more
}

double LabelPlacer::cost(const Rect& rect) const {
  double cost = kOutsideWeight * (rect.width * rect.height - overlap(rect, frame_));
  for (const Obstacle& obstacle : obstacles_) {
    cost += obstacle.weight * overlap(rect, obstacle.rect);
  }
  const auto cell = [](double offset, std::size_t count) {
    return static_cast<std::size_t>(
        std::clamp(std::floor(offset / kCell), 0.0, static_cast<double>(count - 1)));
  };
  const std::size_t right = cell(rect.right() - frame_.x, columns_);
  const std::size_t bottom = cell(rect.bottom() - frame_.y, rows_);
  for (std::size_t row = cell(rect.y - frame_.y, rows_); row <= bottom; ++row) {
    for (std::size_t column = cell(rect.x - frame_.x, columns_); column <= right; ++column) {
      cost += kSpotWeight * spots_[row * columns_ + column];
    }
  }
  return cost;
}

LabelPlacer::Place LabelPlacer::place(const Vector2& mark, double radius, double width,
                                      double height) {
  constexpr std::array<double, 5> kGaps = {3.0, 9.0, 18.0, 30.0, 45.0};
  constexpr double kApartFrom = 15.0;
  constexpr int kDirections = 16;
  Place best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const double gap : kGaps) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const double dx = std::cos(angle), dy = std::sin(angle);
      // The nearest edge or corner of the label is radius + gap away.
      const Vector2 centre{mark.x + dx * (radius + gap + width / 2),
                           mark.y + dy * (radius + gap + height / 2)};
      const Rect rect{centre.x - width / 2, centre.y - height / 2, width, height};
      const double here = cost(rect) + kFarWeight * gap;
      if (here < best_cost) {
        best_cost = here;
        best = {rect, gap >= kApartFrom};
      }
    }
  }
  avoid(best.rect, 8.0);
  return best;
}

}  // namespace elsie::picture
