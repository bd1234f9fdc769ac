#include <algorithm>
#include <cmath>
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
double row_height(const Canvas& canvas, const Row& row, double width) {
  if (row.panels.empty()) return 0.0;
  double aspect = row.aspect;
  if (aspect <= 0.0) {
    for (const Panel& panel : row.panels) {
      aspect = std::max(aspect, natural_aspect(canvas, panel, panel_width(row, width)));
    }
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
  } else if (const auto* rows = std::get_if<RowChart>(&panel)) {
    check_axis(rows->x);
  } else if (const auto* tiles = std::get_if<Tiles>(&panel)) {
    check_axis(tiles->z);
  } else {
    const auto* map = std::get_if<HeatMap>(&panel);
    const Field& field = map ? map->field : std::get<Mesh>(panel).field;
    for (const Axis* axis : {&field.x, &field.y, &field.z}) {
      check_axis(*axis);
    }
  }
}

double natural_aspect(const Canvas& canvas, const Panel& panel, double width) {
  if (const auto* chart = std::get_if<LineChart>(&panel)) {
    return chart->rows.empty() ? 0.5
                               : 0.6 + 16.0 * static_cast<double>(chart->rows.size() + 1) / width;
  }
  if (const auto* tiles = std::get_if<Tiles>(&panel)) {
    return std::min(0.85, 80.0 / width + 0.1 * static_cast<double>(tiles->y.names.size()));
  }
  if (const auto* chart = std::get_if<RowChart>(&panel)) {
    return natural_height(canvas, *chart, width) / width;
  }
  return 0.85;
}

Interval interval_of(const Field& field) {
  Interval range;
  for (const double value : field.values) range.include(value);
  return interval_of(field.z, range.widened());
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
    rows += row_height(ruler, row, width);
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
    Rect area{kPageMargin, y, panel_width(row, width),
              head + stretch * row_height(canvas, row, width)};
    y += area.height + kGap;
    for (const Panel& panel : row.panels) {
      std::visit([&](const auto& shown) { draw(canvas, shown, area, head); }, panel);
      area.x += area.width + kGap;
    }
  }
  write_whole(file, canvas.finish());
}

std::string page_chart(const Panel& panel, const std::string& label, const Size& size) {
  check_panel(panel);
  const double width = size.width;
  const Canvas ruler(FileType::page, 1, 1, 1.0);
  const double head =
      std::visit([&](const auto& shown) { return head_height(ruler, shown, width); }, panel);
  const int height = size.height > 0
                         ? size.height
                         : static_cast<int>(head + width * natural_aspect(ruler, panel, width));
  Canvas canvas(FileType::page, size.width, height, 1.0);
  const Rect area{0.0, 0.0, width, static_cast<double>(height)};
  std::visit([&](const auto& shown) { draw(canvas, shown, area, head); }, panel);
  return canvas.finish(label);
}

namespace {

Rect area_on_screen(int width, int height, double zoom) {
  // The last number of an axis reaches beyond its end.
  constexpr double kAbove = 3.0, kBeside = 18.0;
  return {0.0, kAbove, width / zoom - kBeside, height / zoom - kAbove};
}

}  // namespace

PlotPlace screen_plot(const LineChart& chart, int width, int height, double zoom) {
  check_panel(chart);
  const Canvas canvas(FileType::png, 1, 1, zoom);  // to measure texts
  const Rect area = area_on_screen(width, height, zoom);
  Rect plot;
  const Interval x = place_plot(canvas, chart, area, head_height(canvas, chart, area.width), plot);
  return {{zoom * plot.x, zoom * plot.right()}, {zoom * plot.y, zoom * plot.bottom()}, x};
}

std::vector<std::uint32_t> screen_chart(const Panel& panel, int width, int height, double zoom,
                                        const Style& style) {
  check_panel(panel);
  Canvas canvas(FileType::png, width, height, zoom, style);
  const Rect area = area_on_screen(width, height, zoom);
  std::visit(
      [&](const auto& shown) { draw(canvas, shown, area, head_height(canvas, shown, area.width)); },
      panel);
  return canvas.pixels();
}

}  // namespace elsie::picture
