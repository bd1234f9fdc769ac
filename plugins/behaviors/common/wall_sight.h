// Finds the wall on one side of a robot by its range sensors and lidars.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <elsie/api/perception.h>

#include "seen_points.h"

/// If the wall should be on the right, everything here is mirrored, so that it is always on the
/// left.
class WallSight {
 public:
  struct Settings {
    bool on_left = false;
    double front_angle_rad = 0.0;  // rays up to here look ahead, others to the side
  };

  /// The wall on the side, as a straight line.
  struct Wall {
    elsie::Vector2 along;   // unit vector, with the wall on its left
    double distance = 0.0;  // m from the robot's middle; negative: the robot is behind it
  };

  void set(const Settings& settings) { settings_ = settings; }

  bool looks_ahead(double azimuth_rad) const {
    return std::abs(azimuth_rad) <= settings_.front_angle_rad + kRounding;
  }
  /// Rays that look far back do not see the wall ahead.
  bool looks_aside(double azimuth_rad) const {
    const double azimuth = mirrored(azimuth_rad);
    return azimuth > settings_.front_angle_rad + kRounding && azimuth <= kRearmost + kRounding;
  }

  /// Sorts the readings. Must be called first, once in a step. Points farther than `reach_m` from
  /// the robot's middle are not part of the wall.
  void look(const elsie::Perception& now, double reach_m) {
    reach_m_ = reach_m;
    ahead_.reset();
    side_.clear();
    for_each_ray(now, [&](const SensorRay& seen) {
      const double azimuth = seen.azimuth_rad();
      if (looks_ahead(azimuth)) {
        if (seen.place) ahead_ = std::min(ahead_.value_or(seen.place->x), seen.place->x);
      } else if (looks_aside(azimuth)) {
        Point& point = side_.emplace_back(Point{mirrored(azimuth), {}, kNothing});
        if (!seen.place) return;
        point.point = {seen.place->x, mirrored(seen.place->y)};
        const double away = std::hypot(point.point.x, point.point.y);
        if (away <= reach_m_) point.away = away;
      }
    });
    std::sort(side_.begin(), side_.end(),
              [](const Point& a, const Point& b) { return a.azimuth_rad < b.azimuth_rad; });
  }

  /// The distance of the nearest obstacle ahead from the robot's middle, m.
  std::optional<double> ahead() const { return ahead_; }

  /// The line through the nearest point on the side and the next one towards the front, or else
  /// towards the rear. A single point is taken for a wall across the line of sight.
  std::optional<Wall> wall() const {
    std::size_t nearest = side_.size();
    for (std::size_t i = 0; i < side_.size(); ++i) {
      if (side_[i].away < kNothing &&
          (nearest == side_.size() || side_[i].away < side_[nearest].away)) {
        nearest = i;
      }
    }
    if (nearest == side_.size()) {
      return std::nullopt;
    }
    for (std::size_t i = nearest; i-- > 0 && is_one_wall(nearest, i);) {
      if (is_base(nearest, i)) return through(side_[nearest], side_[i]);
    }
    for (std::size_t i = nearest + 1; i < side_.size() && is_one_wall(nearest, i); ++i) {
      if (is_base(nearest, i)) return through(side_[i], side_[nearest]);
    }
    const Point& only = side_[nearest];
    if (only.away == 0.0) {  // it touches a sensor exactly in the robot's middle
      return Wall{{std::sin(only.azimuth_rad), -std::cos(only.azimuth_rad)}, 0.0};
    }
    return Wall{{only.point.y / only.away, -only.point.x / only.away}, only.away};
  }

 private:
  static constexpr double kNothing = 1e9;  // m
  static constexpr double kBase = 0.03;    // m
  static constexpr double kRounding = 1e-9;
  static constexpr double kRearmost = 150.0 * std::numbers::pi / 180.0;

  struct Point {
    double azimuth_rad = 0.0;
    elsie::Vector2 point;
    double away = kNothing;  // m from the robot's middle
  };

  double mirrored(double value) const { return settings_.on_left ? value : -value; }

  double between(std::size_t a, std::size_t b) const {
    return std::hypot(side_[b].point.x - side_[a].point.x, side_[b].point.y - side_[a].point.y);
  }
  /// Points that are farther apart than the reach are hardly part of one wall.
  bool is_one_wall(std::size_t a, std::size_t b) const {
    return side_[b].away < kNothing && between(a, b) <= reach_m_;
  }
  /// Neighbours in the fan of a lidar are too near to each other to tell a direction.
  bool is_base(std::size_t a, std::size_t b) const { return between(a, b) >= kBase; }

  /// The line from a point to one farther ahead.
  static Wall through(const Point& rear, const Point& front) {
    const elsie::Vector2 step{front.point.x - rear.point.x, front.point.y - rear.point.y};
    const double length = std::hypot(step.x, step.y);
    const elsie::Vector2 along{step.x / length, step.y / length};
    return Wall{along, rear.point.y * along.x - rear.point.x * along.y};
  }

  Settings settings_;
  double reach_m_ = 0.0;
  std::optional<double> ahead_;
  std::vector<Point> side_;  // of the rays on that side, from the front to the rear
};
