// What cameras say together: where the things are that they found, and which of them a robot is to
// go by, so that behaviours and the rules about them speak of the same one.
#pragma once

#include <cmath>
#include <optional>

#include "elsie/api/geometry.h"
#include "elsie/api/perception.h"
#include "elsie/api/reading.h"

namespace elsie {

/// The bearing of a blob that was found, from the robot's forward axis, positive to the left, in
/// (-pi, pi]: the pinhole camera of image.h backwards, and the azimuth of the camera. The picture
/// must have a width.
inline double blob_bearing_rad(const Sensed<VisionReading>& view) {
  const double half = 0.5 * view->width;
  const double in_picture =
      std::atan((half - view->column) / half * std::tan(0.5 * view->horizontal_fov_rad));
  return wrap_angle(in_picture + view.azimuth_rad());
}

/// Of the cameras that have found something the one whose blob has the bearing nearest to straight
/// ahead; of several such the first in the world file. None when nothing was found.
inline std::optional<Sensed<VisionReading>> most_nearly_ahead(const Perception& now) {
  std::optional<Sensed<VisionReading>> nearest;
  double least = 0.0;
  for (const Sensed<VisionReading> view : now.readings<VisionReading>()) {
    if (!view->found || view->width <= 0) {
      continue;
    }
    const double off = std::abs(blob_bearing_rad(view));
    // A billionth of a radian is no difference: of two cameras that are each other's mirror image
    // rounding is not to decide.
    if (!nearest || off < least - 1e-9) {
      nearest = view;
      least = off;
    }
  }
  return nearest;
}

}  // namespace elsie
