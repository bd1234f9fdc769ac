// Finds the wall on one side of a robot in its beams.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <elsie/api/perception.h>

/// If the wall should be on the right, everything here is mirrored, so that it is always on the
/// left.
class WallSight {
 public:
  struct Settings {
    bool on_left = false;
    double front_angle_rad = 0.0;  // beams up to here look ahead, others to the side
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
  /// Beams that look far back do not see the wall ahead.
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
    for (const auto& beam : now.readings<elsie::RangeReading>()) {
      if (!beam->hit) {
        if (looks_aside(beam.azimuth_rad())) {
          side_.push_back({mirrored(beam.azimuth_rad()), {}, kNothing});
        }
        continue;
      }
      const elsie::Vector2 point = point_of(beam);
      if (looks_ahead(beam.azimuth_rad())) {
        ahead_ = std::min(ahead_.value_or(point.x), point.x);
      } else if (looks_aside(beam.azimuth_rad())) {
        const double away = std::hypot(point.x, point.y);
        side_.push_back({mirrored(beam.azimuth_rad()), point, away <= reach_m_ ? away : kNothing});
      }
    }
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
    if (nearest > 0) {
      if (const auto line = through(side_[nearest], side_[nearest - 1])) {
        return line;
      }
    }
    if (nearest + 1 < side_.size()) {
      if (const auto line = through(side_[nearest + 1], side_[nearest])) {
        return line;
      }
    }
    const Point& only = side_[nearest];
    if (only.away == 0.0) {  // it touches a sensor exactly in the robot's middle
      return Wall{{std::sin(only.azimuth_rad), -std::cos(only.azimuth_rad)}, 0.0};
    }
    return Wall{{only.point.y / only.away, -only.point.x / only.away}, only.away};
  }

 private:
  static constexpr double kNothing = 1e9;  // m
  static constexpr double kRounding = 1e-9;
  static constexpr double kRearmost = 150.0 * std::numbers::pi / 180.0;

  struct Point {
    double azimuth_rad = 0.0;
    elsie::Vector2 point;
    double away = kNothing;  // m from the robot's middle
  };

  double mirrored(double value) const { return settings_.on_left ? value : -value; }

  elsie::Vector2 point_of(const elsie::Sensed<elsie::RangeReading>& beam) const {
    const double level = beam->distance_m * std::cos(beam.mounting().pitch_rad);
    return {beam.mounting().position.x + level * std::cos(beam.azimuth_rad()),
            mirrored(beam.mounting().position.y + level * std::sin(beam.azimuth_rad()))};
  }

  /// The line from a point to one farther ahead; none if one of them is missing, or if they are
  /// farther apart than the reach and so hardly part of one wall.
  std::optional<Wall> through(const Point& rear, const Point& front) const {
    const elsie::Vector2 step{front.point.x - rear.point.x, front.point.y - rear.point.y};
    const double length = std::hypot(step.x, step.y);
    if (rear.away >= kNothing || front.away >= kNothing || length < 1e-3 || length > reach_m_) {
      return std::nullopt;
    }
    const elsie::Vector2 along{step.x / length, step.y / length};
    return Wall{along, rear.point.y * along.x - rear.point.x * along.y};
  }

  Settings settings_;
  double reach_m_ = 0.0;
  std::optional<double> ahead_;
  std::vector<Point> side_;  // of the beams on that side, from the front to the rear
};
