// A drawing surface over cairo, in the few strokes that the pictures need.
//
// Coordinates are in units of which the zoom makes pixels; x goes right, y down. Points that are
// not finite are skipped and far ones pulled near, since cairo would answer them with a broken
// surface. Groups and image patterns are left out on purpose: cairo numbers them throughout the
// process, and an SVG would change with what was drawn before.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"

#include "colour.h"
#include "file.h"

namespace elsie::picture {

struct Rect {
  double x = 0.0, y = 0.0;  // upper left corner
  double width = 0.0, height = 0.0;

  double right() const { return x + width; }
  double bottom() const { return y + height; }
  Vector2 centre() const { return {x + width / 2, y + height / 2}; }
};

struct Pen {
  double width = 1.0;
  std::vector<double> dash{};
  bool round = false;  // ends and corners
};

enum class Across { left, centre, right };
enum class Down { top, middle, baseline };

struct TextStyle {
  double size = 13.0;
  bool bold = false;
  Ink ink = kText;
  Across across = Across::left;  // which part of the text lies on the given point
  Down down = Down::baseline;
  double halo = 0.0;   // width of a white rim
  double angle = 0.0;  // clockwise, rad
};

class Canvas {
 public:
  /// A white sheet of width x height pixels.
  Canvas(FileType type, int width, int height, double zoom);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  double zoom() const { return zoom_; }
  /// The nearest coordinate at which a line of one pixel is sharp.
  double crisp(double coordinate) const;

  // The path under construction. fill() and stroke() use it up.
  Canvas& move_to(const Vector2& to);
  Canvas& line_to(const Vector2& to);
  Canvas& close();
  Canvas& line(const Vector2& from, const Vector2& to) { return move_to(from).line_to(to); }
  Canvas& polyline(std::span<const Vector2> points);
  Canvas& polygon(std::span<const Vector2> points) { return polyline(points).close(); }
  Canvas& rectangle(const Rect& rect);
  Canvas& circle(const Vector2& centre, double radius);

  void fill(const Ink& ink);
  void fill_keep(const Ink& ink);
  void stroke(const Ink& ink, const Pen& pen);

  /// From now on nothing is drawn outside of the path, which is used up; until unclip().
  void clip();
  void unclip();

  double text_width(const std::string& text, const TextStyle& style) const;
  void text(const std::string& text, const Vector2& at, const TextStyle& style);
  /// The text, shortened with an ellipsis until it is no wider.
  std::string fitted(const std::string& text, const TextStyle& style, double width) const;

  /// Ends the drawing: the bytes of the file.
  std::string finish();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  double zoom_;
};

/// A clip to the current path for the time of a scope.
class Clip {
 public:
  explicit Clip(Canvas& canvas) : canvas_(canvas) { canvas_.clip(); }
  ~Clip() { canvas_.unclip(); }
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;

 private:
  Canvas& canvas_;
};

/// How large a unit of the drawing is: at 1000 pixels, one pixel. Below 700 pixels text stays at
/// the size that it has there.
double zoom_for_width(int width);

}  // namespace elsie::picture
