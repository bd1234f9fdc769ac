// The reading of an omnidirectional camera.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "elsie/api/image.h"
#include "elsie/api/reading.h"

namespace elsie {

/// The coloured things around the robot, the nearest first.
struct OmnidirectionalReading {
  /// One thing. The colour's channels are from 0 to 255.
  struct Blob {
    double distance_m = 0.0;   // from the camera, along the floor
    double bearing_rad = 0.0;  // from its forward axis, positive to the left
    int red = 0;
    int green = 0;
    int blue = 0;

    Colour colour() const {
      const auto channel = [](int value) {
        return static_cast<std::uint8_t>(std::clamp(value, 0, 255));  // noise may leave the range
      };
      return {channel(red), channel(green), channel(blue)};
    }
    template <class Visitor>
    void visit(Visitor&& visitor) const {
      visitor("distance", distance_m, "m");
      visitor("bearing", bearing_rad, "rad");
      visitor("red", red);
      visitor("green", green);
      visitor("blue", blue);
    }
  };

  static constexpr const char* kind = "omnidirectional";
  std::vector<Blob> blobs;
  std::size_t most = 0;  // blobs that it lists; farther ones are left out

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("blobs", at_most(most, blobs));
  }
};

}  // namespace elsie
