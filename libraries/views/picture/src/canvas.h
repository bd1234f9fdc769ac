// A drawing surface over cairo, with the few operations that the pictures need.
//
// Coordinates are in units that the zoom scales to pixels; x goes right, y down. Points that are
// not finite are skipped and far ones clamped, because they would break cairo's surface. In all
// types cairo holds the current path and measures texts; it paints PNGs and PDFs, and SvgPainter
// SVGs.
#pragma once

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/geometry.h"
#include "elsie/picture/plot.h"

#include "colour.h"
#include "file.h"

namespace elsie::picture {

inline bool finite(const Vector2& point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

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
  Across across = Across::left;  // the part of the text at the given point
  Down down = Down::baseline;
  double halo = 0.0;   // width of a white outline
  double angle = 0.0;  // clockwise, rad
};

class Canvas {
 public:
  /// A sheet of width x height pixels, white unless the colours have another one for it.
  Canvas(FileType type, int width, int height, double zoom, Style colours = {});
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  double zoom() const { return zoom_; }
  /// Whether it is drawn for an HTML page.
  bool in_page() const;
  /// Whether it becomes a text with every shape: an SVG, or a part of a page.
  bool is_text() const;
  /// Whether it has the colours of a screen.
  bool on_screen() const;
  /// The nearest coordinate at which a line of one pixel is sharp.
  double crisp(double coordinate) const;

  // The current path. fill() and stroke() consume it.
  Canvas& move_to(const Vector2& to);
  Canvas& line_to(const Vector2& to);
  /// A cubic Bezier curve.
  Canvas& curve_to(const Vector2& first, const Vector2& second, const Vector2& to);
  Canvas& close();
  Canvas& line(const Vector2& from, const Vector2& to) { return move_to(from).line_to(to); }
  Canvas& polyline(std::span<const Vector2> points);
  Canvas& polygon(std::span<const Vector2> points) { return polyline(points).close(); }
  Canvas& rectangle(const Rect& rect);
  Canvas& circle(const Vector2& centre, double radius);

  void fill(const Ink& ink);
  void fill_keep(const Ink& ink);
  void stroke(const Ink& ink, const Pen& pen);
  /// A filled circle, in an SVG shorter than by circle(). The path must be empty.
  void dot(const Vector2& centre, double radius, const Ink& ink);

  /// Limits drawing to the inside of the path, which is consumed, until unclip().
  void clip();
  void unclip();

  double text_width(const std::string& text, const TextStyle& style) const;
  void text(const std::string& text, const Vector2& at, const TextStyle& style);
  /// The text if it is not wider; else an ellipsis replaces its middle, because names often begin
  /// alike. "" if not even the ellipsis has room.
  std::string fitted(const std::string& text, const TextStyle& style, double width) const;

  /// Everything drawn until close_mark() is one mark. An SVG shows the title when the pointer is
  /// over it.
  void open_mark(const std::string& title);
  void close_mark();

  /// Ends the drawing; returns the bytes of the file. `label`: for readers who do not see it.
  std::string finish(const std::string& label = {});
  /// The pixels of a PNG: 0x??RRGGBB, row by row.
  std::vector<std::uint32_t> pixels();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
  double zoom_;
};

/// Clips to the current path while it lives.
class Clip {
 public:
  explicit Clip(Canvas& canvas) : canvas_(canvas) { canvas_.clip(); }
  ~Clip() { canvas_.unclip(); }
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;

 private:
  Canvas& canvas_;
};

/// Pixels per unit of the drawing: one at a width of 1000 pixels. Below 700 pixels text keeps its
/// size.
double zoom_for_width(int width);

}  // namespace elsie::picture
