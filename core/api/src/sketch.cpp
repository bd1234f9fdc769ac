#include "elsie/api/sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "elsie/base/error.h"

namespace elsie {

void Sketch::points(SketchRole role, std::span<const Vector3> places) {
  add(Kind::points, role, places);
}

void Sketch::line(SketchRole role, std::span<const Vector3> places) {
  if (places.size() < 2) {
    throw base::Error("it draws a line through " + std::to_string(places.size()) +
                      " places; expected two or more");
  }
  add(Kind::line, role, places);
}

void Sketch::line(SketchRole role, const Vector3& from, const Vector3& to) {
  add(Kind::line, role, std::array{from, to});
}

void Sketch::arrow(SketchRole role, const Vector3& from, const Vector3& to) {
  add(Kind::arrow, role, std::array{from, to});
}

void Sketch::arc(SketchRole role, const Vector3& middle, double radius_m, double from_rad,
                 double to_rad) {
  constexpr double kChord = std::numbers::pi / 24.0;  // an angle; a circle has 48 of them
  const double chords = std::clamp(std::ceil(std::abs(to_rad - from_rad) / kChord), 1.0, 480.0);
  std::vector<Vector3> places;
  for (double i = 0.0; i <= chords; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / chords;
    places.push_back(middle + Vector3{radius_m * std::cos(angle), radius_m * std::sin(angle), 0.0});
  }
  line(role, places);
}

void Sketch::circle(SketchRole role, const Vector3& middle, double radius_m) {
  arc(role, middle, radius_m, 0.0, 2.0 * std::numbers::pi);
}

void Sketch::pyramid(SketchRole role, double horizontal_rad, double vertical_rad, double range_m) {
  const double aside = range_m * std::tan(0.5 * horizontal_rad);
  const double above = range_m * std::tan(0.5 * vertical_rad);
  const Vector3 left_top{range_m, aside, above}, left_bottom{range_m, aside, -above};
  const Vector3 right_top{range_m, -aside, above}, right_bottom{range_m, -aside, -above};
  line(role, std::array{Vector3{}, left_top, right_top, right_bottom, left_bottom, left_top});
  for (const Vector3& corner : {left_bottom, right_bottom, right_top}) {
    line(role, {}, corner);
  }
}

void Sketch::text(SketchRole role, const Vector3& place, std::string_view text) {
  add(Kind::text, role, {&place, 1}, text);
}

void Sketch::add(Kind kind, SketchRole role, std::span<const Vector3> places,
                 std::string_view text) {
  if (places_.size() + places.size() > kMostPlaces) {
    throw base::Error("it draws more than " + std::to_string(kMostPlaces) +
                      " places in one sketch");
  }
  marks_.push_back({kind, role, places_.size(), places.size(), std::string(text)});
  for (const Vector3& place : places) {
    if (!std::isfinite(place.x + place.y + place.z)) {
      throw base::Error("it draws a place that is not finite in its sketch");
    }
    places_.push_back(is_in_world_ ? place : own_.point(place));
  }
}

}  // namespace elsie
