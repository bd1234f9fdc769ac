#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include <cairo-pdf.h>
#include <cairo.h>

#include "elsie/base/utf8.h"
#include "elsie/files/clean_text.h"
#include "elsie/picture/svg.h"

#include "svg_painter.h"
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

constexpr double kPointsPerPixel = 0.75;  // 72 points and 96 pixels are an inch

// A PDF without the time of its making: the same picture gives the same bytes.
cairo_surface_t* pdf_surface(std::string& bytes, int width, int height) {
  cairo_surface_t* surface = cairo_pdf_surface_create_for_stream(
      append, &bytes, kPointsPerPixel * width, kPointsPerPixel * height);
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "2000-01-01T00:00:00Z");
  return surface;
}

// Within the range of cairo's 24.8 fixed-point numbers after zooming.
double near(double coordinate) { return std::clamp(coordinate, -1e5, 1e5); }

}  // namespace

struct Canvas::Impl {
  std::optional<SvgPainter> svg;  // none: a PNG or a PDF
  Style colours;                  // by their roles
  bool is_pdf = false;
  std::string pdf;            // its bytes so far
  int width = 0, height = 0;  // pixels
  cairo_surface_t* surface = nullptr;
  cairo_t* cr = nullptr;

  ~Impl() {
    if (cr != nullptr) cairo_destroy(cr);
    if (surface != nullptr) cairo_surface_destroy(surface);
  }

  void set(const Ink& ink) const {
    Ink used = ink;
    if (const auto own = colours.find(ink.role ? ink.role : ""); own != colours.end()) {
      used = picture::ink(own->second).with_alpha(ink.alpha);
    }
    cairo_set_source_rgba(cr, used.red, used.green, used.blue, used.alpha);
  }

  std::string path() const {
    std::string text;
    std::vector<Vector2> line;
    const auto end = [&](bool closed) {
      if (line.size() > 1) text += path_data(line, svg->in_page() ? 1 : 2, closed);
      line.clear();
    };
    cairo_path_t* path = cairo_copy_path_flat(cr);
    for (int i = 0; i < path->num_data; i += path->data[i].header.length) {
      const cairo_path_data_t* data = path->data + i;
      if (data->header.type != CAIRO_PATH_LINE_TO) {
        end(data->header.type == CAIRO_PATH_CLOSE_PATH);
      }
      if (data->header.length > 1) line.push_back({data[1].point.x, data[1].point.y});
    }
    end(false);
    cairo_path_destroy(path);
    return text;
  }

  void select(const TextStyle& style) const {
    cairo_select_font_face(cr, kFont, CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cr, style.size);
  }
};

Canvas::Canvas(FileType type, int width, int height, double zoom, Style colours)
    : impl_(std::make_unique<Impl>()), zoom_(zoom) {
  impl_->colours = std::move(colours);
  if (type == FileType::svg || type == FileType::page) impl_->svg.emplace(type == FileType::page);
  impl_->is_pdf = type == FileType::pdf;
  impl_->width = width;
  impl_->height = height;
  // An SVG needs the surface only to measure texts.
  const bool ruler = impl_->svg.has_value();
  impl_->surface = impl_->is_pdf ? pdf_surface(impl_->pdf, width, height)
                                 : cairo_image_surface_create(CAIRO_FORMAT_RGB24, ruler ? 1 : width,
                                                              ruler ? 1 : height);
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
  if (impl_->is_pdf) cairo_scale(impl_->cr, kPointsPerPixel, kPointsPerPixel);
  cairo_scale(impl_->cr, zoom, zoom);
  // Pixels; circles of an SVG are polygons, and a page has many.
  if (ruler) cairo_set_tolerance(impl_->cr, type == FileType::page ? 0.1 : 0.03);
}

Canvas::~Canvas() = default;

bool Canvas::is_text() const { return impl_->svg.has_value(); }

bool Canvas::in_page() const { return impl_->svg && impl_->svg->in_page(); }

bool Canvas::on_screen() const { return !impl_->colours.empty(); }

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

Canvas& Canvas::curve_to(const Vector2& first, const Vector2& second, const Vector2& to) {
  if (finite(first) && finite(second) && finite(to)) {
    cairo_curve_to(impl_->cr, near(first.x), near(first.y), near(second.x), near(second.y),
                   near(to.x), near(to.y));
  }
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
  fill_keep(ink);
  cairo_new_path(impl_->cr);
}

void Canvas::fill_keep(const Ink& ink) {
  if (impl_->svg) return impl_->svg->fill(impl_->path(), ink);
  impl_->set(ink);
  cairo_fill_preserve(impl_->cr);
}

void Canvas::stroke(const Ink& ink, const Pen& pen) {
  if (impl_->svg) {
    impl_->svg->stroke(impl_->path(), ink, pen);
    cairo_new_path(impl_->cr);
    return;
  }
  impl_->set(ink);
  cairo_set_line_width(impl_->cr, pen.width);
  cairo_set_line_cap(impl_->cr, pen.round ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(impl_->cr, pen.round ? CAIRO_LINE_JOIN_ROUND : CAIRO_LINE_JOIN_MITER);
  cairo_set_dash(impl_->cr, pen.dash.data(), static_cast<int>(pen.dash.size()), 0.0);
  cairo_stroke(impl_->cr);
}

void Canvas::dot(const Vector2& centre, double radius, const Ink& ink) {
  if (!impl_->svg) return circle(centre, radius).fill(ink);
  if (finite(centre)) impl_->svg->dot({near(centre.x), near(centre.y)}, radius, ink);
}

void Canvas::clip() {
  if (impl_->svg) {
    Vector2 from, to;
    cairo_path_extents(impl_->cr, &from.x, &from.y, &to.x, &to.y);
    impl_->svg->clip(impl_->path(), {from.x, from.y, to.x - from.x, to.y - from.y});
    cairo_new_path(impl_->cr);
    return;
  }
  // The clip is part of cairo's saved state; the path is not.
  cairo_save(impl_->cr);
  cairo_clip(impl_->cr);
}

void Canvas::unclip() { impl_->svg ? impl_->svg->unclip() : cairo_restore(impl_->cr); }

void Canvas::open_mark(const std::string& title) {
  if (impl_->svg) impl_->svg->open(clean_text(title));
}

void Canvas::close_mark() {
  if (impl_->svg) impl_->svg->close();
}

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

  if (impl_->svg) {
    return impl_->svg->text(clean, {near(at.x), near(at.y)}, offset.y, style);
  }
  cairo_save(impl_->cr);
  cairo_translate(impl_->cr, near(at.x), near(at.y));
  cairo_rotate(impl_->cr, style.angle);
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
  const std::string whole = clean_text(text), ellipsis(files::kEllipsis);
  if (text_width(whole, style) <= width) return whole;
  // A text that was shortened before still has only one ellipsis.
  const std::size_t cut = whole.find(ellipsis);
  const std::size_t half = base::cut_before(whole, whole.size() / 2);
  const bool is_cut = cut != std::string::npos;
  std::string front = whole.substr(0, is_cut ? cut : half);
  std::string back = whole.substr(is_cut ? whole.rfind(ellipsis) + ellipsis.size() : half);
  for (;;) {
    const std::string shorter = front + ellipsis + back;
    if (text_width(shorter, style) <= width) return shorter;
    if (front.empty() && back.empty()) return {};
    if (front.size() > back.size()) {
      front.resize(base::cut_before(front, front.size() - 1));
    } else {
      back.erase(0, base::character_at(back, 0).bytes);
    }
  }
}

std::string Canvas::finish(const std::string& label) {
  check(cairo_status(impl_->cr));
  if (impl_->svg) return impl_->svg->finish(impl_->width, impl_->height, zoom_, label);
  if (impl_->is_pdf) {
    cairo_surface_finish(impl_->surface);
    check(cairo_surface_status(impl_->surface));
    return impl_->pdf;
  }
  cairo_surface_flush(impl_->surface);
  std::string bytes;
  check(cairo_surface_write_to_png_stream(impl_->surface, append, &bytes));
  return bytes;
}

std::vector<std::uint32_t> Canvas::pixels() {
  check(cairo_status(impl_->cr));
  cairo_surface_flush(impl_->surface);
  std::vector<std::uint32_t> pixels(static_cast<std::size_t>(impl_->width) *
                                    static_cast<std::size_t>(impl_->height));
  // A row of RGB24 has no bytes after its last pixel.
  std::memcpy(pixels.data(), cairo_image_surface_get_data(impl_->surface), 4 * pixels.size());
  return pixels;
}

double zoom_for_width(int width) { return std::max(0.7, width / 1000.0); }

}  // namespace elsie::picture
