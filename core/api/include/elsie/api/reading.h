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
// visit() is optional: it lists the numbers that recordings and live plots show. Their names are
// literals, and every reading of the kind lists the same ones, also a new one; the numbers are
// finite. A sensor whose reading has a number that is not finite ends the run.
//
// A sensor plugin produces readings of one kind, a behaviour asks for them by that type. The core
// knows no kind by name: a plugin defines a new kind in a header of its own, which both sides
// include. The name, the size and the listed members of the struct are compared when a library or
// a world is loaded, so that plugins built against different versions of that header refuse each
// other.
#pragma once

#include <cstddef>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

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
  bool has_name_of(const ReadingKind& other) const {
    return name == other.name || std::strcmp(name, other.name) == 0;
  }
  friend bool operator==(const ReadingKind& a, const ReadingKind& b) {
    return a.size == b.size && a.has_name_of(b);
  }
};

/// True if readings of this type list numbers.
template <class Reading>
constexpr bool kListsNumbers = requires(const Reading& reading,
                                        void (*visitor)(const char*, double)) {
  reading.visit(visitor);
};

/// A number that a new reading lists.
struct ListedNumber {
  static constexpr std::size_t kElsewhere = ~std::size_t{0};

  std::string name;
  const char* literal = nullptr;    // the name as visit() gives it; not to be read later
  std::size_t offset = kElsewhere;  // bytes from the beginning of the struct, if it is a member
  std::size_t size = 0;             // bytes

  friend bool operator==(const ListedNumber& a, const ListedNumber& b) {
    return a.name == b.name && a.offset == b.offset && a.size == b.size;
  }
};

/// A kind of reading that a plugin needs or produces, with the layout that it was compiled with.
struct ReadingDeclaration {
  std::string kind;
  std::size_t size = 0;                 // bytes of the struct
  bool lists_numbers = false;           // it has visit()
  std::vector<ListedNumber> numbers{};  // of a new reading

  template <class Reading>
  static ReadingDeclaration of() {
    ReadingDeclaration declared{Reading::kind, sizeof(Reading), kListsNumbers<Reading>, {}};
    if constexpr (kListsNumbers<Reading>) {
      const Reading fresh{};
      const auto* const begin = reinterpret_cast<const char*>(&fresh);
      fresh.visit([&](const char* name, const auto& number) {
        const auto* const at = reinterpret_cast<const char*>(&number);
        const bool is_member = !std::less<>()(at, begin) && std::less<>()(at, begin + sizeof fresh);
        declared.numbers.push_back(
            {name ? name : "", name,
             is_member ? static_cast<std::size_t>(at - begin) : ListedNumber::kElsewhere,
             sizeof number});
      });
    }
    return declared;
  }

  /// Whether both may exchange readings, if they are of one kind. What a struct without visit() has
  /// inside is not known.
  bool fits(const ReadingDeclaration& other) const {
    return size == other.size &&
           (!lists_numbers || !other.lists_numbers || numbers == other.numbers);
  }
};

}  // namespace elsie
