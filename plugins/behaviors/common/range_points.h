// What range sensors see: beams and the rays of lidars alike.
#pragma once

#include <cmath>
#include <cstddef>

#include <elsie/api/perception.h>
#include <elsie/readings/lidar.h>

/// A surface that a ray has hit.
struct RangePoint {
  elsie::Vector2 place;      // m, in the robot's frame
  elsie::Vector2 ray;        // unit vector, from the sensor along the ray
  double azimuth_rad = 0.0;  // of the ray, from the robot's heading
};

/// Calls use(RangePoint) for each ray that has hit something: beams first, then lidars, each with
/// its rays from left to right. Sensors on segments are left out: their frames are not the robot's.
template <class Use>
void for_each_range_point(const elsie::Perception& now, const Use& use) {
  const auto tell = [&](const elsie::Mounting& mounting, double azimuth_rad, double distance_m) {
    const elsie::Vector2 ray{std::cos(azimuth_rad), std::sin(azimuth_rad)};
    const double level = distance_m * std::cos(mounting.pitch_rad);
    use(RangePoint{{mounting.position.x + level * ray.x, mounting.position.y + level * ray.y},
                   ray,
                   azimuth_rad});
  };
  for (const auto& beam : now.readings<elsie::RangeReading>()) {
    if (beam->hit && beam.mounting().segment == 0) {
      tell(beam.mounting(), beam.azimuth_rad(), beam->distance_m);
    }
  }
  for (const auto& lidar : now.readings<elsie::LidarReading>()) {
    if (lidar.mounting().segment != 0) continue;
    for (std::size_t i = 0; i < lidar->ranges_m.size(); ++i) {
      if (lidar->ranges_m[i] < lidar->max_range_m) {
        tell(lidar.mounting(), lidar.azimuth_rad() + lidar->azimuth_rad(i), lidar->ranges_m[i]);
      }
    }
  }
}

/// The number of rays of the robot.
inline std::size_t ray_count(const elsie::Perception& now) {
  std::size_t count = now.readings<elsie::RangeReading>().size();
  for (const auto& lidar : now.readings<elsie::LidarReading>()) count += lidar->ranges_m.size();
  return count;
}
