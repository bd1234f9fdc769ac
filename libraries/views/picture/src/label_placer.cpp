#include "label_placer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace elsie::picture {
namespace {

constexpr double kCell = 4.0;
constexpr double kSpotWeight = 3.0;  // relative to units of area of an obstacle of weight 1
constexpr double kOutsideWeight = 20.0;
constexpr double kFarWeight = 1.5;  // per unit of distance

double overlap(const Rect& a, const Rect& b) {
  const double width = std::min(a.right(), b.right()) - std::max(a.x, b.x);
  const double height = std::min(a.bottom(), b.bottom()) - std::max(a.y, b.y);
  return width > 0 && height > 0 ? width * height : 0.0;
}

Vector2 nearest(const Rect& rect, const Vector2& to) {
  return {std::clamp(to.x, rect.x, rect.right()), std::clamp(to.y, rect.y, rect.bottom())};
}

// True if a line crosses a rectangle; tested every few units.
bool crosses(const Vector2& from, const Vector2& to, const Rect& rect) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const int steps = static_cast<int>(length / 3.0) + 1;
  for (int i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / steps;
    const Vector2 at{from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)};
    if (at.x > rect.x && at.x < rect.right() && at.y > rect.y && at.y < rect.bottom()) return true;
  }
  return false;
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
  count = std::min(count + 1, 3);  // more ink on ink hides nothing more
}

double LabelPlacer::cost(const Rect& rect, const Vector2& mark) const {
  double cost = kOutsideWeight * (rect.width * rect.height - overlap(rect, frame_));
  for (const Obstacle& obstacle : obstacles_) {
    const Vector2 middle = obstacle.rect.centre();
    // A label may be close to its own mark.
    const bool own = std::hypot(middle.x - mark.x, middle.y - mark.y) < 0.5;
    if (own && obstacle.weight < 1.0) continue;
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

std::optional<LabelPlacer::Place> LabelPlacer::place(const Vector2& mark, double radius,
                                                     double width, double height) {
  constexpr std::array<double, 8> kGaps = {3.0, 9.0, 18.0, 30.0, 45.0, 65.0, 90.0, 120.0};
  constexpr double kApartFrom = 15.0;
  constexpr int kDirections = 24;
  constexpr double kBetween = 5.0;  // distance between labels
  std::optional<Place> best;
  double best_cost = std::numeric_limits<double>::infinity();
  for (const double gap : kGaps) {
    for (int i = 0; i < kDirections; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kDirections;
      const double dx = std::cos(angle), dy = std::sin(angle);
      // The nearest edge or corner of the label is radius + gap away.
      const Vector2 centre{mark.x + dx * (radius + gap + width / 2),
                           mark.y + dy * (radius + gap + height / 2)};
      const Rect rect{centre.x - width / 2, centre.y - height / 2, width, height};
      const Rect room{rect.x - kBetween, rect.y - kBetween, width + 2 * kBetween,
                      height + 2 * kBetween};
      const Vector2 end = nearest(rect, mark);
      const bool apart = gap >= kApartFrom;
      const bool taken =
          std::any_of(labels_.begin(), labels_.end(),
                      [&](const Rect& other) {
                        return overlap(room, other) > 0.0 || (apart && crosses(mark, end, other));
                      }) ||
          std::any_of(leaders_.begin(), leaders_.end(),
                      [&](const Leader& other) { return crosses(other.from, other.to, rect); });
      if (taken) continue;
      const double here = cost(rect, mark) + kFarWeight * gap;
      if (here < best_cost) {
        best_cost = here;
        best = {rect, apart};
      }
    }
  }
  if (!best) {
    ++left_out_;
    return best;
  }
  labels_.push_back(best->rect);
  if (best->apart) leaders_.push_back({mark, nearest(best->rect, mark)});
  return best;
}

}  // namespace elsie::picture
