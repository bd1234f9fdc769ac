// Level rays against upright boxes, several at a time: the inner loop of range sensors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "elsie/api/sensor.h"

#include "plane.h"
#include "scene_body.h"

namespace elsie::physics {

/// Rays that run level. The processor's vector instructions take four of them at once; the numbers
/// are those of one at a time.
class LevelRays {
 public:
  static constexpr std::size_t kMost = 16;

  /// Takes at most kMost rays, as in Engine::cast_rays(). Returns whether `within` and all rays are
  /// level and finite; otherwise the object must not be used.
  bool set(const Frame& within, std::span<const RayQuery> rays);

  /// The origin of the first ray.
  const Vector2& middle() const { return extent_.middle; }
  /// No ray reaches further from there, m.
  double reach() const { return extent_.reach; }
  /// The height of the lowest ray, m.
  double lowest() const { return extent_.lowest; }

  /// The rays that meet the circle: the first in bit 0.
  std::uint32_t meeting_circle(const SceneBody& target) const;

  Vector3 origin(std::size_t ray) const {
    const Group& group = groups_[ray / kLanes];
    return {group.x[ray % kLanes], group.y[ray % kLanes], group.z[ray % kLanes]};
  }
  Vector3 direction(std::size_t ray) const {
    const Group& group = groups_[ray / kLanes];
    return {group.along_x[ray % kLanes], group.along_y[ray % kLanes], 0.0};
  }
  double nearest(std::size_t ray) const { return groups_[ray / kLanes].nearest[ray % kLanes]; }
  void shorten(std::size_t ray, double distance) {
    groups_[ray / kLanes].nearest[ray % kLanes] = distance;
    groups_[ray / kLanes].found[ray % kLanes] = -1;
  }
  /// Shortens the rays that meet one of the boxes, which are at most kMostBoxes.
  static constexpr std::size_t kMostBoxes = 16;
  void meet_boxes(std::span<const SceneBody* const> boxes);
  /// Sets the distances of the rays.
  void answer(std::span<RayQuery> rays) const;

  static constexpr std::size_t kLanes = 4;
  using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
  using Flags = std::int64_t __attribute__((vector_size(kLanes * sizeof(double))));
  struct Group {
    Lanes x, y, z;  // origins
    Lanes along_x, along_y;
    Lanes flat;     // the square of the length of (along_x, along_y)
    Lanes nearest;  // m
    Flags found;    // -1 if it met something
  };
  /// What is known about all rays.
  struct Extent {
    Vector2 middle;
    double reach = 0.0;
    double lowest = 0.0;
  };

 private:
  std::array<Group, kMost / kLanes> groups_;
  std::size_t used_ = 0;  // groups
  Extent extent_;
};

}  // namespace elsie::physics
