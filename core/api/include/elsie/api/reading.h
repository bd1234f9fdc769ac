// The readings that sensors give to behaviours.
//
// A *kind* of reading is a plain struct that names itself:
//
//   struct LightReading {
//     static constexpr const char* kind = "light";
//     double lux = 0.0;
//     template <class Visitor>
//     void visit(Visitor&& visitor) const { visitor("lux", lux); }
//   };
//
// visit() is optional: it lists the numbers that recordings and live plots show.
//
// A sensor plugin produces readings of one kind, a behaviour asks for them by that type. The core
// knows no kind by name: a plugin defines a new kind in a header of its own, which both sides
// include. Name and size of the struct are compared when a world is loaded, so that two plugins
// built against different versions of that header refuse each other.
#pragma once

#include <cstddef>
#include <cstring>

#include "elsie/api/image.h"

namespace elsie {

/// Distance to the nearest surface along a ray.
struct RangeReading {
  static constexpr const char* kind = "range";
  double distance_m = 0.0;  // max_range_m when nothing was hit
  double max_range_m = 0.0;
  bool hit = false;  // whether there is a surface within range

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance_m", distance_m);
    visitor("hit", hit);
  }
};

/// The result of a query whether anything is inside a volume.
struct ProximityReading {
  static constexpr const char* kind = "proximity";
  bool detected = false;
  double max_range_m = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("detected", detected);
  }
};

/// The picture of a camera and the position of the object found in it. Columns and rows are counted
/// from the picture's upper left corner, in pixels; see Camera.
struct VisionReading {
  static constexpr const char* kind = "vision";
  bool found = false;
  double column = 0.0;              // of the blob's centroid; 0 when nothing was found
  double row = 0.0;                 // of the blob's centroid; 0 when nothing was found
  double area_px = 0.0;             // of the blob; 0 when nothing was found
  int width = 100;                  // of the picture, px
  int height = 100;                 // of the picture, px
  double horizontal_fov_rad = 0.0;  // of the camera
  Image raw;                        // the camera's picture
  Image processed;                  // the mask of the blob search: one channel, 255 where it may be

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("found", found);
    visitor("column", column);
    visitor("row", row);
    visitor("area_px", area_px);
  }
};

/// A number of a reading, by name, for recordings and plots.
struct NamedValue {
  const char* name = "";
  double value = 0.0;
};

/// The identity of a kind of reading.
struct ReadingKind {
  const char* name = "";
  std::size_t size = 0;

  template <class Reading>
  static constexpr ReadingKind of() {
    return {Reading::kind, sizeof(Reading)};
  }
  friend bool operator==(const ReadingKind& a, const ReadingKind& b) {
    return a.size == b.size && (a.name == b.name || std::strcmp(a.name, b.name) == 0);
  }
};

}  // namespace elsie
