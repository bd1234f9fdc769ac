// The readings that sensors give to behaviours.
//
// A *kind* of reading is a plain struct that names itself:
//
//   struct LidarReading {
//     static constexpr const char* kind = "lidar";
//     std::vector<double> ranges_m;  // one for each ray, from left to right
//     double max_range_m = 0.0;
//     template <class Visitor>
//     void visit(Visitor&& visitor) const { visitor("ranges", ranges_m, "m"); }
//   };
//
// visit() is optional: it lists what recordings, plots, tests and the noise of a world file see of
// a reading, each with its name and, where it has one, its unit:
// - a number or a bool;
// - an array of numbers (std::vector, std::array, std::span, []), whose size is that of
//   SensorOf::blank() in every reading;
// - a list whose length changes, as at_most(largest, list): of numbers, or of structs that have a
//   visit() of their own;
// - an Image.
// Every reading lists the same names in the same order. Numbers are finite: a sensor whose reading
// has another one ends the run.
//
// A sensor plugin produces readings of one kind, a behaviour asks for them by that type. The core
// knows no kind by name: a plugin defines a new kind in a header of its own, which both sides
// include. Its name and its layout (the size of the struct and what it lists) are compared when a
// library or a world is loaded and when a behaviour reads, so that plugins built against different
// versions of that header refuse each other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
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
    visitor("distance_m", distance_m, "m");
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
    visitor("column", column, "px");
    visitor("row", row, "px");
    visitor("area_px", area_px, "px");
    visitor("raw", raw);
    visitor("processed", processed);
  }
};

/// A list whose length changes from one reading to the next, in visit(). A longer one than
/// `largest` ends the run; `largest` is the same in every reading. The list must outlive visit().
template <class Values>
struct AtMost {
  std::size_t largest;
  const Values& values;
};
template <class Values>
AtMost<Values> at_most(std::size_t largest, const Values& values) {
  return {largest, values};
}

/// How the numbers of a field are stored.
enum class FieldType : std::uint8_t {
  boolean,
  int8,
  int16,
  int32,
  int64,
  uint8,
  uint16,
  uint32,
  uint64,
  real32,
  real64,
  picture  // an Image, no number
};

/// One field of a reading: what visit() lists under one name. It refers to the reading.
struct ReadingField {
  std::string_view group{};  // the name of its list of structs; empty: it is in none
  std::size_t item = 0;      // the struct's place in that list
  bool in_list = true;       // false: the list is shorter now, and there is no such struct
  std::string_view name;
  std::string_view unit{};  // "m"; empty: visit() gives none
  FieldType type = FieldType::real64;
  bool is_array = false;
  bool varies = false;       // an array whose length changes
  std::size_t size = 1;      // numbers that it may have: of an array that varies, the most
  std::size_t count = 1;     // numbers that it has now, at most `size` in a sound reading
  const void* at = nullptr;  // the first of them; of a picture, the Image
  bool is_stored = false;    // it is part of the reading, so that it may be changed

  bool is_number() const { return type != FieldType::picture; }
  /// Number i < count.
  double number(std::size_t i) const;
  /// Changes number i < count of a reading that is not const; integers are rounded, within the
  /// range of their type. Requires is_stored.
  void set_number(std::size_t i, double value) const;
  const Image& picture() const { return *static_cast<const Image*>(at); }
  /// "distance_m", or "blobs.distance" in a list of structs: how files name the field.
  std::string path() const;
  /// "distance_m", "ranges.0", "blobs.2.distance": the name of its number i < size.
  std::string column(std::size_t i) const;
};

/// Called for each field of a reading, in the order of visit().
using FieldVisit = std::function<void(const ReadingField&)>;

namespace detail {

template <class Value>
constexpr FieldType field_type() {
  static_assert(std::is_arithmetic_v<Value>,
                "visit() lists numbers, arrays of numbers, lists by at_most(), and Image");
  if constexpr (std::is_same_v<Value, bool>) {
    return FieldType::boolean;
  } else if constexpr (std::is_floating_point_v<Value>) {
    static_assert(sizeof(Value) <= 8, "visit() lists float and double, no long double");
    return sizeof(Value) == 4 ? FieldType::real32 : FieldType::real64;
  } else {
    constexpr int size = sizeof(Value) == 1   ? 0
                         : sizeof(Value) == 2 ? 1
                         : sizeof(Value) == 4 ? 2
                                              : 3;
    constexpr FieldType first = std::is_signed_v<Value> ? FieldType::int8 : FieldType::uint8;
    return static_cast<FieldType>(static_cast<int>(first) + size);
  }
}

template <class Values>
concept Array = requires(const Values& values) {
  std::span(values);
};
template <Array Values>
using Element = typename decltype(std::span(std::declval<const Values&>()))::value_type;

/// A visitor that does nothing, to ask whether a type has visit().
struct NoVisitor {
  template <class Value>
  void operator()(std::string_view /*name*/, const Value& /*value*/,
                  std::string_view /*unit*/ = {}) const {}
};

}  // namespace detail

/// True if readings of this type list fields.
template <class Reading>
constexpr bool kListsFields = requires(const Reading& reading) {
  reading.visit(detail::NoVisitor{});
};

namespace detail {

template <class Values>
constexpr bool kHasFixedSize = std::is_array_v<Values> || requires {
  std::tuple_size<Values>::value;
};

/// Makes a ReadingField of each value that visit() lists. kOfItem: of a struct in a list.
template <bool kOfItem>
class FieldLister {
 public:
  /// `begin` and `size`: the memory of the reading, or of a struct in one of its lists.
  FieldLister(const void* begin, std::size_t size, const FieldVisit& visit,
              const ReadingField& common = {})
      : begin_(static_cast<const char*>(begin)), size_(size), visit_(visit), common_(common) {}

  template <class Value>
  void operator()(std::string_view name, const Value& value, std::string_view unit = {}) const {
    ReadingField field = common_;
    field.name = name;
    field.unit = unit;
    field.is_stored = is_inside(&value);
    if constexpr (std::is_same_v<Value, Image>) {
      field.type = FieldType::picture;
      field.at = &value;
      visit_(field);
    } else if constexpr (Array<Value>) {
      static_assert(!kOfItem || kHasFixedSize<Value>,
                    "a struct in a list of a reading has no arrays but std::array");
      list_array(field, std::span<const Element<Value>>(value), std::size(value), false);
    } else {
      field.type = field_type<Value>();
      field.at = &value;
      visit_(field);
    }
  }
  template <class Values>
  void operator()(std::string_view name, const AtMost<Values>& list,
                  std::string_view unit = {}) const {
    static_assert(!kOfItem, "a struct in a list of a reading has no lists of its own");
    if constexpr (kListsFields<Element<Values>>) {
      list_items(name, list);
    } else {
      ReadingField field = common_;
      field.name = name;
      field.unit = unit;
      field.is_stored = is_inside(&list.values);
      list_array(field, std::span<const Element<Values>>(list.values), list.largest, true);
    }
  }

 private:
  bool is_inside(const void* address) const {
    const auto* const at = static_cast<const char*>(address);
    return !std::less<>()(at, begin_) && std::less<>()(at, begin_ + size_);
  }

  template <class Number>
  void list_array(ReadingField& field, std::span<const Number> values, std::size_t size,
                  bool varies) const {
    field.type = field_type<Number>();
    field.is_array = true;
    field.varies = varies;
    field.size = size;
    field.count = field.in_list ? values.size() : 0;
    field.at = values.data();
    visit_(field);
  }

  /// The structs of a list, and blank ones in the places that are not taken now; at least one.
  template <class Values>
  void list_items(std::string_view name, const AtMost<Values>& list) const {
    using Item = Element<Values>;
    const std::span<const Item> items(list.values);
    const Item blank{};
    const std::size_t listed = std::max({list.largest, items.size(), std::size_t{1}});
    for (std::size_t i = 0; i < listed; ++i) {
      const Item& item = i < items.size() ? items[i] : blank;
      ReadingField common;
      common.group = name;
      common.item = i;
      common.in_list = i < items.size();
      common.count = common.in_list ? 1 : 0;
      common.size = i < list.largest ? 1 : 0;
      item.visit(FieldLister<true>(&item, sizeof item, visit_, common));
    }
  }

  const char* begin_;
  std::size_t size_;
  const FieldVisit& visit_;
  ReadingField common_;  // what its fields have in common
};

/// What every update checks of a reading, fast: that its numbers are finite, and the sizes of its
/// arrays.
class ReadingCheck {
 public:
  bool is_finite = true;
  bool fits = true;         // no list is longer than it may be
  std::uint64_t sizes = 0;  // a hash of the sizes of arrays, and of the largest sizes of lists

  template <class Value>
  void operator()(std::string_view /*name*/, const Value& value, std::string_view /*unit*/ = {}) {
    if constexpr (std::is_floating_point_v<Value>) {
      is_finite &= value - value == 0;
    } else if constexpr (Array<Value>) {
      add_size(std::size(value));
      check_numbers(std::span<const Element<Value>>(value));
    }
  }
  template <class Values>
  void operator()(std::string_view /*name*/, const AtMost<Values>& list,
                  std::string_view /*unit*/ = {}) {
    add_size(list.largest);
    fits &= list.values.size() <= list.largest;
    if constexpr (kListsFields<Element<Values>>) {
      for (const auto& item : list.values) {
        ReadingCheck of_item;
        item.visit(of_item);
        is_finite &= of_item.is_finite;
      }
    } else {
      check_numbers(std::span<const Element<Values>>(list.values));
    }
  }

 private:
  void add_size(std::size_t size) { sizes = sizes * 0x100000001b3ULL + size + 1; }
  template <class Number>
  void check_numbers(std::span<const Number> values) {
    if constexpr (std::is_floating_point_v<Number>) {
      for (const Number value : values) {
        is_finite &= value - value == 0;
      }
    }
  }
};

}  // namespace detail

/// Calls `visit` for each field of a reading; for none if it has no visit().
template <class Reading>
void visit_fields(const Reading& reading, const FieldVisit& visit) {
  if constexpr (kListsFields<Reading>) {
    reading.visit(detail::FieldLister<false>(&reading, sizeof reading, visit));
  }
}

/// A field as a plugin was compiled with it.
struct FieldDeclaration {
  std::string group;  // see ReadingField
  std::string name;
  std::string unit;
  FieldType type = FieldType::real64;
  bool is_array = false;
  std::size_t offset = 0;  // bytes from the beginning of the struct; of what is not stored, 0
  bool is_single = false;  // a number that is stored there

  bool operator==(const FieldDeclaration&) const = default;
  /// See ReadingField.
  std::string path() const { return group.empty() ? name : group + "." + name; }
  /// "distance_m (m)", "ranges (m, an array)"
  std::string in_words() const;
};

/// A kind of reading that a plugin needs or produces, with the layout that it was compiled with.
struct ReadingDeclaration {
  std::string kind;
  std::size_t size = 0;       // bytes of the struct; 0: what is needed may have any layout
  bool lists_fields = false;  // it has visit()
  std::vector<FieldDeclaration> fields{};
  /// Visits the fields of such a reading, for who does not know the struct. Empty: unknown.
  std::function<void(const void*, const FieldVisit&)> visit{};

  template <class Reading>
  static ReadingDeclaration of() {
    ReadingDeclaration declared{Reading::kind, sizeof(Reading), kListsFields<Reading>, {}};
    declared.visit = [](const void* reading, const FieldVisit& each) {
      visit_fields(*static_cast<const Reading*>(reading), each);
    };
    const Reading fresh{};
    visit_fields(fresh, [&](const ReadingField& field) { declared.add(field, &fresh); });
    return declared;
  }

  /// Adds a field of a new reading.
  void add(const ReadingField& field, const void* fresh);
  /// Whether both may exchange readings, if they are of one kind. What a struct without visit() has
  /// inside is not known.
  bool fits(const ReadingDeclaration& other) const;
  /// The fields as a number, never 0: the same for layouts that fit.
  std::uint64_t layout() const;
};

/// The identity of a kind of reading.
struct ReadingKind {
  const char* name = "";
  std::size_t size = 0;
  std::uint64_t layout = 0;  // ReadingDeclaration::layout(), 0: it has no visit()

  template <class Reading>
  static const ReadingKind& of() {
    static const ReadingKind kind{
        Reading::kind, sizeof(Reading),
        kListsFields<Reading> ? ReadingDeclaration::of<Reading>().layout() : 0};
    return kind;
  }
  bool has_name_of(const ReadingKind& other) const {
    return name == other.name || std::strcmp(name, other.name) == 0;
  }
  /// Whether a struct of one kind can be read as one of the other.
  bool has_layout_of(const ReadingKind& other) const {
    return size == other.size && (layout == other.layout || layout == 0 || other.layout == 0);
  }
  friend bool operator==(const ReadingKind& a, const ReadingKind& b) {
    return a.has_name_of(b) && a.has_layout_of(b);
  }
};

}  // namespace elsie
