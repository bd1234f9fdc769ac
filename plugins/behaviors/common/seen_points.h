// The rays of range sensors and lidars, and the points at which they see something.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>

#include <elsie/api/perception.h>
#include <elsie/readings/lidar.h>

/// A ray of a sensor, in the robot's frame.
struct SensorRay {
  elsie::Vector2 ray;                   // unit vector along it, seen from above
  std::optional<elsie::Vector2> place;  // m, of the surface that it has hit; none: nothing is there

  double azimuth_rad() const { return std::atan2(ray.y, ray.x); }
};

/// A surface that a ray has hit, in the robot's frame.
struct SeenPoint {
  elsie::Vector2 place;  // m
  elsie::Vector2 ray;    // unit vector along the ray, seen from above

  double azimuth_rad() const { return std::atan2(ray.y, ray.x); }
};

/// Calls use(SensorRay) for each of them: beams first, then lidars, each with its rays from left to
/// right. Leaves out the sensors of segments. What is no higher than the floor is nothing.
template <class Use>
void for_each_ray(const elsie::Perception& now, Use use) {
  constexpr double kFloor = 0.005;  // m
  for (const auto& beam : now.readings<elsie::RangeReading>()) {
    const elsie::Mounting& at = beam.mounting();
    if (at.segment != 0) continue;
    const double height = at.position.z + beam->distance_m * std::sin(at.pitch_rad);
    SensorRay seen{{std::cos(at.azimuth_rad), std::sin(at.azimuth_rad)}, {}};
    if (beam->hit && !(at.pitch_rad < 0.0 && height < kFloor)) {
      const double level = beam->distance_m * std::cos(at.pitch_rad);
      seen.place = {at.position.x + level * seen.ray.x, at.position.y + level * seen.ray.y};
    }
    use(seen);
  }
  for (const auto& scan : now.readings<elsie::LidarReading>()) {
    const elsie::Mounting& at = scan.mounting();
    if (at.segment != 0) continue;
    const double ahead = std::cos(at.pitch_rad), up = std::sin(at.pitch_rad);
    const double c = std::cos(at.azimuth_rad), s = std::sin(at.azimuth_rad);
    for (std::size_t i = 0; i < scan->ranges_m.size(); ++i) {
      const bool hit = scan->ranges_m[i] > 0.0 && scan->ranges_m[i] < scan->max_range_m;
      const double range = hit ? scan->ranges_m[i] : 1.0;
      const double x = range * std::cos(scan->azimuth_rad(i));
      const double y = range * std::sin(scan->azimuth_rad(i));
      const elsie::Vector2 way{c * ahead * x - s * y, s * ahead * x + c * y};
      const double level = std::hypot(way.x, way.y);
      if (!(level > 0.0)) continue;
      SensorRay seen{{way.x / level, way.y / level}, {}};
      if (hit && !(up != 0.0 && at.position.z + x * up < kFloor)) {
        seen.place = {at.position.x + way.x, at.position.y + way.y};
      }
      use(seen);
    }
  }
}

/// Calls use(SeenPoint) for each surface that one of these rays has hit.
template <class Use>
void for_each_seen_point(const elsie::Perception& now, Use use) {
  for_each_ray(now, [&](const SensorRay& seen) {
    if (seen.place) use(SeenPoint{*seen.place, seen.ray});
  });
}

/// The azimuth of the nearest point that is seen in a corridor: from the robot's middle `ahead_m`
/// in this direction, and `aside_m` to either side of that.
inline std::optional<double> nearest_in_corridor(const elsie::Perception& now, double direction_rad,
                                                 double ahead_m, double aside_m) {
  const double c = std::cos(direction_rad), s = std::sin(direction_rad);
  double nearest = std::numeric_limits<double>::infinity();
  std::optional<double> azimuth;
  for_each_seen_point(now, [&](const SeenPoint& seen) {
    const elsie::Vector2& point = seen.place;
    const double along = c * point.x + s * point.y, aside = c * point.y - s * point.x;
    const double range = std::hypot(point.x, point.y);
    if (along > 0.0 && along <= ahead_m && std::abs(aside) < aside_m && range < nearest) {
      nearest = range;
      azimuth = std::atan2(point.y, point.x);
    }
  });
  return azimuth;
}

/// Half the diagonal of the chassis: the robot as a disc, m.
inline double body_radius(const elsie::OwnState& self) {
  return 0.5 * std::hypot(self.length_m, self.width_m);
}

/// The number of these rays.
inline std::size_t ray_count(const elsie::Perception& now) {
  std::size_t count = 0;
  for_each_ray(now, [&](const SensorRay&) { ++count; });
  return count;
}

/// Throws std::invalid_argument if the robot has neither range sensors nor lidars.
inline void check_sees_points(const elsie::Perception& example) {
  if (ray_count(example) == 0) {
    throw std::invalid_argument(
        "it needs a lidar, or range sensors such as beam_range, and the robot has none of either; "
        "add one");
  }
}
