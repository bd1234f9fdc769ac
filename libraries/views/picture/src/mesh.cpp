#include <algorithm>
#include <array>
#include <cmath>

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

// An isometric view of the unit cube: x goes to the lower right, y to the upper right, z up.
struct View {
  Vector2 origin;     // the position of (0, 0, 0)
  double side = 1.0;  // of the floor, in units of the drawing
  double rise = 1.0;  // of the height

  Vector2 operator()(double x, double y, double z) const {
    constexpr double kCos = 0.866, kSin = 0.42;
    return {origin.x + side * kCos * (x + y), origin.y + side * kSin * (x - y) - rise * z};
  }
};

View fit(const Rect& box) {
  constexpr double kCos = 0.866, kSin = 0.42, kRise = 0.62;
  const double side = std::min(box.width / (2 * kCos), box.height / (2 * kSin + kRise));
  View view;
  view.side = side;
  view.rise = kRise * side;
  const double height = side * (2 * kSin + kRise);
  view.origin = {box.centre().x - side * kCos,
                 box.centre().y - height / 2 + view.rise + kSin * side};
  return view;
}

void draw_walls(Canvas& canvas, const View& view, const Ticks& x, const Interval& x_range,
                const Ticks& y, const Interval& y_range, const Ticks& z, const Interval& z_range) {
  const std::array<Vector2, 4> left{view(0, 0, 0), view(0, 1, 0), view(0, 1, 1), view(0, 0, 1)};
  const std::array<Vector2, 4> right{view(0, 1, 0), view(1, 1, 0), view(1, 1, 1), view(0, 1, 1)};
  const std::array<Vector2, 4> floor{view(0, 0, 0), view(1, 0, 0), view(1, 1, 0), view(0, 1, 0)};
  canvas.polygon(left).fill(hex(0xf3f4f6));
  canvas.polygon(right).fill(hex(0xf8f9fa));
  canvas.polygon(floor).fill(hex(0xfbfbfc));
  for (const double tick : x.at) {
    const double at = x_range.part(tick);
    canvas.move_to(view(at, 0, 0)).line_to(view(at, 1, 0)).line_to(view(at, 1, 1));
  }
  for (const double tick : y.at) {
    const double at = y_range.part(tick);
    canvas.move_to(view(1, at, 0)).line_to(view(0, at, 0)).line_to(view(0, at, 1));
  }
  for (const double tick : z.at) {
    const double at = z_range.part(tick);
    canvas.move_to(view(0, 0, at)).line_to(view(0, 1, at)).line_to(view(1, 1, at));
  }
  canvas.stroke(hex(0xdcdfe3), {.width = 1});
}

void draw_surface(Canvas& canvas, const View& view, const Field& field, const Interval& range) {
  // A coarse net is more readable than a fine one; it always includes the border.
  constexpr std::size_t kLines = 31;
  const auto pick = [](std::size_t i, std::size_t count, std::size_t of) {
    return i * (count - 1) / (of - 1);
  };
  const std::size_t columns = std::min(kLines, field.columns);
  const std::size_t rows = std::min(kLines, field.rows);
  struct Corner {
    Vector2 at;
    double part = 0.0;
  };
  const auto corner = [&](std::size_t i, std::size_t j) {
    const std::size_t column = pick(i, field.columns, columns), row = pick(j, field.rows, rows);
    const double value = field.values[row * field.columns + column];
    const double part = std::isfinite(value) ? std::clamp(range.part(value), 0.0, 1.0) : value;
    const double x = static_cast<double>(column) / static_cast<double>(field.columns - 1);
    const double y = static_cast<double>(row) / static_cast<double>(field.rows - 1);
    return Corner{view(x, y, part), part};
  };
  // From the back (high y, low x) to the front.
  for (std::size_t j = rows - 1; j-- > 0;) {
    for (std::size_t i = 0; i + 1 < columns; ++i) {
      const std::array<Corner, 4> quad{corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                       corner(i, j + 1)};
      const double part = (quad[0].part + quad[1].part + quad[2].part + quad[3].part) / 4;
      if (!std::isfinite(part)) continue;
      const std::array<Vector2, 4> outline{quad[0].at, quad[1].at, quad[2].at, quad[3].at};
      const Ink colour = viridis(part);
      canvas.polygon(outline).fill_keep(colour);
      canvas.stroke(mix(colour, part < 0.5 ? kPaper : kText, 0.28),
                    {.width = 0.7, .dash = {}, .round = true});
    }
  }
}

// Ticks and label of an edge from a to b, with the labels on the side of `out`.
void draw_edge(Canvas& canvas, const Vector2& a, const Vector2& b, const Vector2& out,
               Across across, const Ticks& ticks, const Interval& range, const std::string& label,
               double label_offset) {
  canvas.line(a, b).stroke(kFrame, {.width = 1});
  const auto along = [&](double part) {
    return Vector2{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
  };
  const auto off = [&](const Vector2& p, double distance) {
    return Vector2{p.x + distance * out.x, p.y + distance * out.y};
  };
  for (const double tick : ticks.at) {
    const Vector2 at = along(range.part(tick));
    canvas.line(at, off(at, 5)).stroke(kFrame, {.width = 1});
    canvas.text(ticks.label(tick), off(at, 9),
                {.size = kTick, .across = across, .down = Down::middle});
  }
  const double angle = std::atan2(b.y - a.y, b.x - a.x);
  canvas.text(canvas.fitted(label, {.size = kLabel}, std::hypot(b.x - a.x, b.y - a.y)),
              off(along(0.5), label_offset),
              {.size = kLabel, .across = Across::centre, .down = Down::middle, .angle = angle});
}

}  // namespace

void draw(Canvas& canvas, const Mesh& mesh, const Rect& area, double head) {
  const Field& field = mesh.field;
  const Interval x_range{*field.x.low, *field.x.high};
  const Interval y_range{*field.y.low, *field.y.high};
  const Interval z_range = interval_of(field);
  const Ticks x = nice_ticks(x_range.low, x_range.high, 5);
  const Ticks y = nice_ticks(y_range.low, y_range.high, 5);
  const Ticks z = nice_ticks(z_range.low, z_range.high, 5);

  constexpr double kSide = 52, kBelow = 34;
  const Rect box{area.x + kSide, area.y + head, std::max(10.0, area.width - kSide - 20),
                 std::max(10.0, area.height - head - kBelow)};
  const View view = fit(box);
  draw_walls(canvas, view, x, x_range, y, y_range, z, z_range);
  draw_surface(canvas, view, field, z_range);
  draw_edge(canvas, view(0, 0, 0), view(1, 0, 0), {-0.45, 0.89}, Across::right, x, x_range,
            with_unit(field.x.label, field.x.unit), 42);
  draw_edge(canvas, view(1, 0, 0), view(1, 1, 0), {0.45, 0.89}, Across::left, y, y_range,
            with_unit(field.y.label, field.y.unit), 42);
  draw_edge(canvas, view(0, 0, 0), view(0, 0, 1), {-1, 0}, Across::right, z, z_range,
            with_unit(field.z.label, field.z.unit), 44);
  const TextStyle title{.size = kPanelTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(mesh.title, title, area.width), {area.x, area.y}, title);
}

}  // namespace elsie::picture
