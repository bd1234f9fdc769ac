#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <cairo-svg.h>
#include <cairo.h>

#include "svg_text.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr const char* kFont = "DejaVu Sans";

cairo_status_t append(void* sink, const unsigned char* data, unsigned length) {
  static_cast<std::string*>(sink)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("The picture could not be drawn: ") +
                           cairo_status_to_string(status) + ".");
}

// Within the range of cairo's 24.8 fixed-point numbers after zooming.
double near(double coordinate) { return std::clamp(coordinate, -1e5, 1e5); }

// cairo names the sheet by a counter of the process. Nothing refers to it; without the number, the
// same drawing gives the same file.
void forget_number(std::string& svg) {
  const std::string name = "id=\"surface";
  const std::size_t found = svg.find(name);
  if (found == std::string::npos) return;
  const std::size_t digits = found + name.size();
  const std::size_t end = svg.find_first_not_of("0123456789", digits);
  if (end != std::string::npos) svg.erase(digits, end - digits);
}

}  // namespace

struct Canvas::Impl {
  FileType type = FileType::png;
  std::string svg;
  SvgTexts texts;  // only in an SVG
  cairo_surface_t* surface = nullptr;
  cairo_t* cr = nullptr;

  ~Impl() {
    if (cr != nullptr) cairo_destroy(cr);
    if (surface != nullptr) cairo_surface_destroy(surface);
  }

  void set(const Ink& ink) const {
    cairo_set_source_rgba(cr, ink.red, ink.green, ink.blue, ink.alpha);
  }

  void select(const TextStyle& style) const {
    cairo_select_font_face(cr, kFont, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, style.size);
  }
};

Canvas::Canvas(FileType type, int width, int height, double zoom)
    : impl_(std::make_unique<Impl>()), zoom_(zoom) {
  impl_->type = type;
  if (type == FileType::svg) {
    impl_->surface = cairo_svg_surface_create_for_stream(append, &impl_->svg, width, height);
    cairo_svg_surface_set_document_unit(impl_->surface, CAIRO_SVG_UNIT_PX);
  } else {
    impl_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  }
  impl_->cr = cairo_create(impl_->surface);
  check(cairo_status(impl_->cr));

  // Unhinted metrics: the layout is the same at every zoom and in both types.
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_set_font_options(impl_->cr, options);
  cairo_font_options_destroy(options);

  impl_->set(kPaper);
  cairo_paint(impl_->cr);
  cairo_scale(impl_->cr, zoom, zoom);
}

Canvas::~Canvas() = default;

double Canvas::crisp(double coordinate) const {
  return (std::floor(coordinate * zoom_) + 0.5) / zoom_;
}

Canvas& Canvas::move_to(const Vector2& to) {
  if (finite(to)) cairo_move_to(impl_->cr, near(to.x), near(to.y));
  return *this;
}

Canvas& Canvas::line_to(const Vector2& to) {
  if (finite(to)) cairo_line_to(impl_->cr, near(to.x), near(to.y));
  return *this;
}

Canvas& Canvas::close() {
  cairo_close_path(impl_->cr);
  return *this;
}

Canvas& Canvas::polyline(std::span<const Vector2> points) {
  cairo_new_sub_path(impl_->cr);
  for (const Vector2& point : points) line_to(point);
  return *this;
}

Canvas& Canvas::rectangle(const Rect& rect) {
  if (finite({rect.x, rect.y}) && finite({rect.right(), rect.bottom()})) {
    const double x = near(rect.x), y = near(rect.y);
    cairo_rectangle(impl_->cr, x, y, near(rect.right()) - x, near(rect.bottom()) - y);
  }
  return *this;
}

Canvas& Canvas::circle(const Vector2& centre, double radius) {
  if (finite(centre) && radius > 0.0 && std::isfinite(radius)) {
    cairo_new_sub_path(impl_->cr);
    cairo_arc(impl_->cr, near(centre.x), near(centre.y), near(radius), 0.0, 2.0 * std::numbers::pi);
    cairo_close_path(impl_->cr);
  }
  return *this;
}

void Canvas::fill(const Ink& ink) {
  impl_->set(ink);
  cairo_fill(impl_->cr);
}

void Canvas::fill_keep(const Ink& ink) {
  impl_->set(ink);
  cairo_fill_preserve(impl_->cr);
}

void Canvas::stroke(const Ink& ink, const Pen& pen) {
  impl_->set(ink);
  cairo_set_line_width(impl_->cr, pen.width);
  cairo_set_line_cap(impl_->cr, pen.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(impl_->cr, pen.round ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
  cairo_set_dash(impl_->cr, pen.dash.data(), static_cast<int>(pen.dash.size()), 0.0);
  cairo_stroke(impl_->cr);
}

void Canvas::clip() {
  // The clip is part of cairo's saved state; the path is not.
  cairo_save(impl_->cr);
  cairo_clip(impl_->cr);
}

void Canvas::unclip() { cairo_restore(impl_->cr); }

double Canvas::text_width(const std::string& text, const TextStyle& style) const {
  impl_->select(style);
  cairo_text_extents_t extents;
  cairo_text_extents(impl_->cr, clean_text(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(const std::string& text, const Vector2& at, const TextStyle& style) {
  const std::string clean = clean_text(text);
  if (clean.empty() || !finite(at)) return;
  impl_->select(style);
  cairo_text_extents_t extents;
  cairo_text_extents(impl_->cr, clean.c_str(), &extents);
  Vector2 offset;
  if (style.across == Across::centre) offset.x = -extents.x_advance / 2;
  if (style.across == Across::right) offset.x = -extents.x_advance;
  // Uses the height of capitals, not of this text, so that neighbours share a baseline.
  constexpr double kCapital = 0.73;
  if (style.down == Down::middle) offset.y = kCapital * style.size / 2;
  if (style.down == Down::top) offset.y = kCapital * style.size;

  cairo_save(impl_->cr);
  cairo_translate(impl_->cr, near(at.x), near(at.y));
  cairo_rotate(impl_->cr, style.angle);
  if (impl_->type == FileType::svg) {
    TextStyle scaled = style;
    scaled.size *= zoom_;
    scaled.halo *= zoom_;
    impl_->set(impl_->texts.add(clean, {zoom_ * near(at.x), zoom_ * near(at.y)}, zoom_ * offset.y,
                                scaled));
    cairo_new_path(impl_->cr);
    cairo_rectangle(impl_->cr, offset.x, offset.y - style.size, std::max(extents.x_advance, 1.0),
                    1.3 * style.size);
    cairo_fill(impl_->cr);
    cairo_restore(impl_->cr);
    return;
  }
  if (style.halo > 0.0) {
    cairo_move_to(impl_->cr, offset.x, offset.y);
    cairo_text_path(impl_->cr, clean.c_str());
    stroke(kPaper.with_alpha(0.9), {.width = 2 * style.halo, .dash = {}, .round = true});
  }
  impl_->set(style.ink);
  cairo_move_to(impl_->cr, offset.x, offset.y);
  cairo_show_text(impl_->cr, clean.c_str());
  cairo_new_path(impl_->cr);
  cairo_restore(impl_->cr);
}

std::string Canvas::fitted(const std::string& text, const TextStyle& style, double width) const {
  const std::string whole = clean_text(text);
  if (text_width(whole, style) <= width) return whole;
  std::string shorter = whole;
  while (!shorter.empty()) {
    shorter = without_tail(shorter, 1);
    if (text_width(shorter + "\xE2\x80\xA6", style) <= width) return shorter + "\xE2\x80\xA6";
  }
  return {};
}

std::string Canvas::finish() {
  check(cairo_status(impl_->cr));
  if (impl_->type == FileType::png) {
    cairo_surface_flush(impl_->surface);
    std::string bytes;
    check(cairo_surface_write_to_png_stream(impl_->surface, append, &bytes));
    return bytes;
  }
  cairo_surface_finish(impl_->surface);
  check(cairo_surface_status(impl_->surface));
  forget_number(impl_->svg);
  impl_->texts.put_into(impl_->svg);
  return std::move(impl_->svg);
}

double zoom_for_width(int width) { return std::max(0.7, width / 1000.0); }

}  // namespace elsie::picture
