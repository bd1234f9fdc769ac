// How a plugin shows what it senses, thinks or wants: lines and points in the picture of the world.
//
//   void sketch(elsie::Sketch& sketch) const override {
//     sketch.arrow(elsie::SketchRole::wish, {0, 0, 0}, {0.2, 0, 0});
//   }
//
// Pictures, recordings and the window draw the sketches of all plugins, and know no kind of plugin.
// A mark has a role instead of a colour, so that viewers draw all of one role alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "elsie/api/geometry.h"

namespace elsie {

/// What a mark stands for.
enum class SketchRole : std::uint8_t {
  range,   // how far a sensor looks
  hit,     // what it has found
  field,   // a quantity at a place, or in an area
  target,  // a place to go to, or to keep away from
  wish,    // a motion that a plugin wants
  belief,  // what it takes to be there
  message  // from the robot that said it to the one that heard it: Elsie draws these
};
inline constexpr const char* kSketchRoles[] = {"range", "hit",    "field",  "target",
                                               "wish",  "belief", "message"};

/// The marks of one plugin at one instant. Places are in m, in the plugin's own frame: a sensor's
/// or an actuator's looks along x; that of a behaviour, coordinator, drive or localisation is its
/// robot's (x ahead, z = 0 on the floor); a measure's is the world. Every function throws
/// base::Error for numbers that are not finite, and for more than kMostPlaces places in all.
class Sketch {
 public:
  static constexpr std::size_t kMostPlaces = 100'000;

  enum class Kind : std::uint8_t { points, line, arrow, text };
  struct Mark {
    Kind kind;
    SketchRole role;
    std::size_t first;  // of its places: a line has two or more, an arrow two, a text one
    std::size_t count;
    std::string text{};
  };

  /// `own`: the plugin's frame in the world.
  explicit Sketch(const Frame& own) : own_(own) {}

  void points(SketchRole role, std::span<const Vector3> places);
  void point(SketchRole role, const Vector3& place) { points(role, {&place, 1}); }
  /// A line through these places, two or more.
  void line(SketchRole role, std::span<const Vector3> places);
  void line(SketchRole role, const Vector3& from, const Vector3& to);
  void arrow(SketchRole role, const Vector3& from, const Vector3& to);
  /// Part of a circle that lies flat in the frame; angles from its x axis, counter-clockwise.
  void arc(SketchRole role, const Vector3& middle, double radius_m, double from_rad, double to_rad);
  void circle(SketchRole role, const Vector3& middle, double radius_m);
  /// The edges of a rectangular pyramid with its top at the origin, along the x axis; the angles
  /// are full ones.
  void pyramid(SketchRole role, double horizontal_rad, double vertical_rad, double range_m);
  void text(SketchRole role, const Vector3& place, std::string_view text);

  /// Whether places of the marks that follow are in the frame of the world.
  void in_world(bool yes = true) { is_in_world_ = yes; }

  std::span<const Mark> marks() const { return marks_; }
  /// The places of a mark, in the world.
  std::span<const Vector3> places(const Mark& mark) const {
    return std::span(places_).subspan(mark.first, mark.count);
  }
  bool empty() const { return marks_.empty(); }

 private:
  void add(Kind kind, SketchRole role, std::span<const Vector3> places, std::string_view text = {});

  Frame own_;
  bool is_in_world_ = false;
  std::vector<Vector3> places_;
  std::vector<Mark> marks_;
};

}  // namespace elsie
