// The three polar histograms of VFH+ (Ulrich and Borenstein 1998).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <elsie/api/perception.h>
#include <elsie/api/remember.h>

#include "seen_points.h"

/// Sectors in the world, from the east to the left.
class PolarHistogram {
 public:
  struct Settings {
    int sectors = 72;
    double range = 1.0;           // m, obstacles farther off do not count
    double low = 0.5;             // free below
    double high = 0.6;            // blocked above
    double turning_radius = 0.0;  // m, 0: it turns on the spot
  };

  void set(const Settings& settings) {
    set_ = settings;
    primary_.resize(static_cast<std::size_t>(set_.sectors), 0.0);
    binary_.resize(primary_.size(), 0.0);
    masked_.resize(primary_.size(), 0);
  }
  void reset() { std::fill(binary_.begin(), binary_.end(), 0.0); }
  void remember(elsie::Memory& memory) {
    memory("binary", binary_);
    binary_.resize(primary_.size(), 0.0);
  }

  /// In each step. `radius_m`: of the robot, with its safety distance; what is farther than
  /// `farthest_m` does not count.
  void update(const elsie::Perception& now, double radius_m, double farthest_m) {
    const double heading = now.self().pose.heading_rad;
    std::fill(primary_.begin(), primary_.end(), 0.0);
    right_ = -std::numbers::pi;
    left_ = std::numbers::pi;
    for_each_seen_point(now, [&](const SeenPoint& seen) {
      const elsie::Vector2& point = seen.place;
      if (std::hypot(point.x, point.y) <= farthest_m) {
        add(point, heading, radius_m);
      }
    });
    for (std::size_t k = 0; k < primary_.size(); ++k) {
      if (primary_[k] > set_.high) {
        binary_[k] = 1.0;
      } else if (primary_[k] < set_.low) {
        binary_[k] = 0.0;
      }
      const double off = elsie::wrap_angle(static_cast<double>(k) * width() - heading);
      masked_[k] = binary_[k] > 0.0 || off < right_ || off > left_;
    }
  }

  /// How near obstacles are in a direction of the world: 0 out of range, 1 at the robot's middle.
  double nearness(double direction_rad) const { return primary_[sector(direction_rad)]; }

  /// Calls use(right, span) for each opening of the masked histogram: the direction of its first
  /// sector in the world, and the angle from that to its last sector, to the left. Returns false if
  /// nothing is blocked: then it calls nothing.
  template <class Use>
  bool for_each_opening(Use use) const {
    const auto blocked = std::find(masked_.begin(), masked_.end(), 1);
    if (blocked == masked_.end()) return false;
    // Once round to the left, from a blocked sector to itself.
    const auto first = static_cast<std::size_t>(blocked - masked_.begin());
    std::size_t last = 0;  // blocked one
    for (std::size_t i = 1; i <= masked_.size(); ++i) {
      if (masked_[(first + i) % masked_.size()] == 0) continue;
      if (i > last + 1) {
        use(static_cast<double>(first + last + 1) * width(),
            static_cast<double>(i - last - 2) * width());
      }
      last = i;
    }
    return true;
  }

 private:
  double width() const { return 2.0 * std::numbers::pi / set_.sectors; }
  /// The sector whose middle is nearest to a direction.
  std::size_t sector(double direction_rad) const {
    const long k = std::lround(direction_rad / width()) % set_.sectors;
    return static_cast<std::size_t>(k < 0 ? k + set_.sectors : k);
  }

  /// Adds a point to the primary histogram, enlarged by the robot; and says how far to either side
  /// the robot can turn before it.
  void add(const elsie::Vector2& point, double heading, double radius) {
    const double away = std::hypot(point.x, point.y);
    const double magnitude = 1.0 - (away / set_.range) * (away / set_.range);
    if (magnitude <= 0.0) return;
    const double beta = std::atan2(point.y, point.x);
    const double gamma = away > radius ? std::asin(radius / away) : 0.5 * std::numbers::pi;
    const auto reaches = static_cast<long>(std::floor(gamma / width() + 0.5));
    const auto middle = static_cast<long>(sector(heading + beta));
    for (long k = middle - reaches; k <= middle + reaches; ++k) {
      double& most =
          primary_[static_cast<std::size_t>((k % set_.sectors + set_.sectors) % set_.sectors)];
      most = std::max(most, magnitude);
    }
    if (set_.turning_radius == 0.0 || magnitude < set_.low) return;
    const double circle = set_.turning_radius + radius;
    if (beta < 0.0 && std::hypot(point.x, point.y + set_.turning_radius) < circle) {
      right_ = std::max(right_, beta);
    } else if (beta >= 0.0 && std::hypot(point.x, point.y - set_.turning_radius) < circle) {
      left_ = std::min(left_, beta);
    }
  }

  Settings set_;
  std::vector<double> primary_;      // nearness of obstacles
  std::vector<double> binary_;       // 1: blocked
  std::vector<char> masked_;         // 1: blocked
  double right_ = 0.0, left_ = 0.0;  // rad from the heading: what the turning circles leave
};
