// What sensors hand to behaviours.
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
// knows no kind by name: a plugin brings a new one in a header of its own, and both sides include
// it. Name and size of the struct are compared when a world is loaded, so that two plugins built
// against different versions of that header refuse each other.
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
  bool hit = false;  // whether there was a surface within range

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("distance_m", distance_m);
    visitor("hit", hit);
  }
};

/// Whether anything is inside a volume.
struct ProximityReading {
  static constexpr const char* kind = "proximity";
  bool detected = false;
  double max_range_m = 0.0;

  template <class Visitor>
  void visit(Visitor&& visitor) const {
    visitor("detected", detected);
  }
};

/// What a camera sees, and where in its picture the thing is that it looks for. Columns and rows
/// are counted from the picture's upper left corner, in pixels; see Camera.
struct VisionReading {
  static constexpr const char* kind = "vision";
  bool found = false;
  double column = 0.0;              // of the blob's centre of area; 0 when nothing was found
  double row = 0.0;                 // likewise
  double area_px = 0.0;             // of the blob; 0 when nothing was found
  int width = 100;                  // of the picture, px
  int height = 100;                 // of the picture, px
  double horizontal_fov_rad = 0.0;  // of the camera
  Image raw;                        // as the camera took it
  Image processed;  // as the blob was looked for in it: one channel, 255 where it may be

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
