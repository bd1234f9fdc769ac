// SVG as text: numbers, colours and path data.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/api/image.h"

namespace elsie::picture {

/// At most `decimals` decimals, the same in every locale: "0.25", "3"; never "-0".
std::string short_number(double value, int decimals);

/// "#d0311e"
std::string hex_text(const Colour& colour);

/// The data of a path: "M10 20l3-4 5 6z". Coordinates are rounded; steps that vanish are left out.
class PathData {
 public:
  explicit PathData(int decimals = 0);

  void move_to(const Vector2& to);
  void line_to(const Vector2& to) { add('l', {&to, 1}); }
  /// A cubic Bezier curve: its two control points and its end.
  void curve_to(std::span<const Vector2, 3> points) { add('c', points); }
  void close();
  void polyline(std::span<const Vector2> points);
  const std::string& text() const { return text_; }

 private:
  struct Place {
    long x = 0, y = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  Place place_of(const Vector2& point) const;
  void add(char command, std::span<const Vector2> points);
  void append(long value);

  std::string text_;
  int decimals_;
  double scale_;
  char last_ = 0;  // command; 0: the next one begins a line
  Place at_, start_;
};

}  // namespace elsie::picture
