// The readings of several cameras together: where the objects are that they found, and which one
// counts, so that behaviours and the rules about them use the same object.
#pragma once

#include <cmath>
#include <optional>

#include "elsie/api/geometry.h"
#include "elsie/api/perception.h"
#include "elsie/api/reading.h"

namespace elsie {

/// The bearing of a found blob from the robot's forward axis, positive to the left, in (-pi, pi]:
/// the inverse of the pinhole camera of image.h plus the camera's azimuth. The width of the picture
/// must not be 0.
inline double blob_bearing_rad(const Sensed<VisionReading>& view) {
  const double half = 0.5 * view->width;
  const double in_picture =
      std::atan((half - view->column) / half * std::tan(0.5 * view->horizontal_fov_rad));
  return wrap_angle(in_picture + view.azimuth_rad());
}

/// Of the cameras that found something, the one whose blob is nearest to straight ahead; of
/// several, the first in the world file. None when nothing was found.
inline std::optional<Sensed<VisionReading>> most_nearly_ahead(const Perception& now) {
  std::optional<Sensed<VisionReading>> nearest;
  double least = 0.0;
  for (const Sensed<VisionReading> view : now.readings<VisionReading>()) {
    if (!view->found || view->width <= 0) continue;
    const double off = std::abs(blob_bearing_rad(view));
    // Less than a billionth of a radian does not count: rounding must not decide between two
    // cameras that are mirror images of each other.
    if (!nearest || off < least - 1e-9) {
      nearest = view;
      least = off;
    }
  }
  return nearest;
}

}  // namespace elsie
