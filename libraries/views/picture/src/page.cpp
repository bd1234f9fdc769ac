#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "elsie/picture/plot.h"

#include "panel.h"
#include "text.h"

namespace elsie::picture {
namespace {

constexpr double kGap = 22.0;  // between panels
constexpr double kSubtitle = 19.0;
constexpr double kRowTitle = kPanelTitle + 14;

double header_height(const Page& page) {
  return picture::header_height(page.title, page.subtitles) + (page.subtitles.empty() ? 0 : 12);
}

double panel_width(const Row& row, double width) {
  const auto count = static_cast<double>(row.panels.size());
  return (width - 2 * kPageMargin - kGap * (count - 1)) / count;
}

// The largest head among the panels, so that neighbouring plots line up.
double row_head(const Canvas& canvas, const Row& row, double width) {
  double head = 0.0;
  for (const Panel& panel : row.panels) {
    head = std::max(head, std::visit(
                              [&](const auto& shown) {
                                return head_height(canvas, shown, panel_width(row, width));
                              },
                              panel));
  }
  return head;
}

// Height without the heads.
double row_height(const Row& row, double width) {
  if (row.panels.empty()) return 0.0;
  double aspect = row.aspect;
  if (aspect <= 0.0) {
    for (const Panel& panel : row.panels) aspect = std::max(aspect, natural_aspect(panel));
  }
  return aspect * panel_width(row, width);
}

void check_axis(const Axis& axis) {
  const bool finite =
      (!axis.low || std::isfinite(*axis.low)) && (!axis.high || std::isfinite(*axis.high));
  if (finite && (!axis.low || !axis.high || *axis.low < *axis.high)) return;
  throw std::invalid_argument("The axis '" + clean_text(axis.label) +
                              "' cannot be drawn: its borders must be finite and the lower one " +
                              "below the upper one.");
}

void check_field(const Field& field) {
  check_axis(field.x);
  check_axis(field.y);
  check_axis(field.z);
  if (!field.x.low || !field.x.high || !field.y.low || !field.y.high) {
    throw std::invalid_argument("A field needs the borders of both of its axes.");
  }
  if (field.columns < 2 || field.rows < 2 || field.values.size() != field.columns * field.rows) {
    throw std::invalid_argument("A field of " + std::to_string(field.columns) + " x " +
                                std::to_string(field.rows) + " cannot be drawn from " +
                                std::to_string(field.values.size()) +
                                " values: it needs at least 2 x 2, and one value for each.");
  }
}

}  // namespace

double header_height(const std::string& title, const std::vector<std::string>& subtitles) {
  return kPageMargin + (title.empty() ? 0.0 : kPageTitle + 10) +
         kSubtitle * static_cast<double>(subtitles.size());
}

double draw_header(Canvas& canvas, const std::string& title,
                   const std::vector<std::string>& subtitles, double width) {
  double y = header_height(title, {});
  const TextStyle bold{.size = kPageTitle, .bold = true, .down = Down::top};
  canvas.text(canvas.fitted(title, bold, width - 2 * kPageMargin), {kPageMargin, kPageMargin},
              bold);
  const TextStyle below{.size = 14, .ink = kFaintText, .down = Down::top};
  for (const std::string& line : subtitles) {
    canvas.text(canvas.fitted(line, below, width - 2 * kPageMargin), {kPageMargin, y}, below);
    y += kSubtitle;
  }
  return y;
}

void hatch(Canvas& canvas, const Rect& around, double every, const Ink& ink) {
  const Clip clip(canvas);
  const double first = std::floor((around.x - around.height) / every) * every;
  for (double x = first; x < around.right(); x += every) {
    canvas.line({x, around.bottom()}, {x + around.height, around.y});
  }
  canvas.stroke(ink, {.width = 1.0});
}

void check_panel(const Panel& panel) {
  if (const auto* chart = std::get_if<LineChart>(&panel)) {
    const LineChart drawn = in_exponents({"", chart->x, chart->y, {}});
    check_axis(drawn.x);
    check_axis(drawn.y);
  } else if (const auto* map = std::get_if<HeatMap>(&panel)) {
    check_field(map->field);
  } else {
    check_field(std::get<Mesh>(panel).field);
  }
}

double natural_aspect(const Panel& panel) {
  if (std::holds_alternative<LineChart>(panel)) return 0.5;
  return 0.85;
}

Interval interval_of(const Axis& axis, const Interval& otherwise) {
  Interval result{axis.low.value_or(otherwise.low), axis.high.value_or(otherwise.high)};
  if (result.low < result.high) return result;
  // Only one limit was given, and the data are beyond it.
  const double span = std::max(1.0, std::abs(result.low) * 0.1);
  if (axis.low) return {result.low, result.low + span};
  return {result.high - span, result.high};
}

Interval interval_of(const Field& field) {
  Interval range;
  for (const double value : field.values) range.include(value);
  return interval_of(field.z, range.widened());
}

PlaneMap map_to(const Rect& plot, const Interval& x, const Interval& y) {
  PlaneMap map;
  map.scale_x = plot.width / x.span();
  map.scale_y = -plot.height / y.span();
  map.origin_x = plot.x - map.scale_x * x.low;
  map.origin_y = plot.bottom() - map.scale_y * y.low;
  return map;
}

Ticks ticks_of(const Axis& axis, const Interval& range, double length, double room) {
  const auto about = [&](double every) { return std::max(2, static_cast<int>(length / every)); };
  if (!axis.logarithmic) return nice_ticks(range.low, range.high, about(room));
  const int powers = static_cast<int>(range.span());
  Ticks ticks = nice_ticks(range.low, range.high, std::clamp(powers, 1, about(room / 2)));
  std::erase_if(ticks.at, [](double tick) { return tick != std::round(tick); });
  ticks.powers = true;
  return ticks;
}

double y_labels_width(const Canvas& canvas, const Axis& axis, const Interval& range,
                      double height) {
  const Ticks ticks = ticks_of(axis, range, height);
  double widest = 0.0;
  for (const double tick : ticks.at) {
    widest = std::max(widest, canvas.text_width(ticks.label(tick), {.size = kTick}));
  }
  return widest;
}

void draw_x_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double y) {
  for (const double tick : ticks.at) {
    const double x = canvas.crisp(map.pixel({tick, 0}).x);
    canvas.line({x, canvas.crisp(y)}, {x, canvas.crisp(y) + 4}).stroke(kFrame, {.width = 1});
    canvas.text(ticks.label(tick), {x, y + 8},
                {.size = kTick, .across = Across::centre, .down = Down::top});
  }
}

double draw_y_ticks(Canvas& canvas, const Ticks& ticks, const PlaneMap& map, double x,
                    const Ink& ink) {
  const TextStyle style{.size = kTick, .ink = ink, .across = Across::right, .down = Down::middle};
  double widest = 0.0;
  for (const double tick : ticks.at) {
    const double y = canvas.crisp(map.pixel({0, tick}).y);
    canvas.line({canvas.crisp(x) - 4, y}, {canvas.crisp(x), y}).stroke(kFrame, {.width = 1});
    canvas.text(ticks.label(tick), {x - 8, y}, style);
    widest = std::max(widest, canvas.text_width(ticks.label(tick), style));
  }
  return widest;
}

void draw_axes(Canvas& canvas, const Rect& plot, const Axis& x, const Interval& x_range,
               const Axis& y, const Interval& y_range, bool grid) {
  const PlaneMap map = map_to(plot, x_range, y_range);
  const Ticks across = ticks_of(x, x_range, plot.width, 80.0);
  const Ticks up = ticks_of(y, y_range, plot.height);
  const double left = canvas.crisp(plot.x), bottom = canvas.crisp(plot.bottom());
  const auto x_of = [&](double tick) { return canvas.crisp(map.pixel({tick, 0}).x); };
  const auto y_of = [&](double tick) { return canvas.crisp(map.pixel({0, tick}).y); };
  if (grid) {
    for (const double tick : across.at) {
      canvas.line({x_of(tick), plot.y}, {x_of(tick), plot.bottom()});
    }
    for (const double tick : up.at) canvas.line({plot.x, y_of(tick)}, {plot.right(), y_of(tick)});
    canvas.stroke(kGrid, {.width = 1});
  }
  draw_x_ticks(canvas, across, map, plot.bottom());
  const double widest = draw_y_ticks(canvas, up, map, plot.x, kText);
  canvas.move_to({left, plot.y}).line_to({left, bottom}).line_to({plot.right(), bottom});
  canvas.stroke(kFrame, {.width = 1});

  const TextStyle below{.size = kLabel, .across = Across::centre, .down = Down::top};
  canvas.text(canvas.fitted(with_unit(x.label, x.unit), below, plot.width),
              {plot.centre().x, plot.bottom() + 27}, below);
  const TextStyle beside{.size = kLabel, .across = Across::centre, .angle = -std::numbers::pi / 2};
  canvas.text(canvas.fitted(with_unit(y.label, y.unit), beside, plot.height),
              {plot.x - 16 - widest, plot.centre().y}, beside);
}

void save_page(const Page& page, const std::filesystem::path& file, const Size& size) {
  const FileType type = file_type(file);
  check_size(size);
  for (const Row& row : page.rows) {
    for (const Panel& panel : row.panels) check_panel(panel);
  }

  const double zoom = zoom_for_width(size.width);
  const double width = size.width / zoom;
  const double header = header_height(page);
  const Canvas ruler(FileType::png, 1, 1, zoom);
  double rows = 0.0, gaps = 0.0;  // parts that stretch with the height, and parts that do not
  for (const Row& row : page.rows) {
    if (row.panels.empty()) continue;
    rows += row_height(row, width);
    gaps += kGap + row_head(ruler, row, width) + (row.title.empty() ? 0.0 : kRowTitle);
  }
  const double wanted = header + rows + gaps - (gaps > 0 ? kGap : 0) + kPageMargin;
  // A page with very many rows is compressed into the highest possible picture.
  const int height = size.height > 0
                         ? size.height
                         : static_cast<int>(std::clamp(std::ceil(wanted * zoom), 100.0, 16000.0));
  const double stretch = rows > 0 ? std::max(0.05, (height / zoom - (wanted - rows)) / rows) : 1.0;

  Canvas canvas(type, size.width, height, zoom);
  draw_header(canvas, page.title, page.subtitles, width);
  double y = header;
  for (const Row& row : page.rows) {
    if (row.panels.empty()) continue;
    if (!row.title.empty()) {
      const TextStyle style{.size = kPanelTitle, .bold = true, .down = Down::top};
      canvas.text(canvas.fitted(row.title, style, width - 2 * kPageMargin), {kPageMargin, y},
                  style);
      y += kRowTitle;
    }
    const double head = row_head(canvas, row, width);
    Rect area{kPageMargin, y, panel_width(row, width), head + stretch * row_height(row, width)};
    y += area.height + kGap;
    for (const Panel& panel : row.panels) {
      std::visit([&](const auto& shown) { draw(canvas, shown, area, head); }, panel);
      area.x += area.width + kGap;
    }
  }
  write_whole(file, canvas.finish());
}

std::string page_chart(const LineChart& chart, const std::string& label, const Size& size) {
  check_panel(chart);
  Canvas canvas(FileType::page, size.width, size.height, 1.0);
  const double width = size.width, height = size.height;
  draw(canvas, chart, {0.0, 0.0, width, height}, head_height(canvas, chart, width));
  return canvas.finish(label);
}

}  // namespace elsie::picture
