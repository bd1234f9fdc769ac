// Learning curves, from what plugins report of their training.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "elsie/picture/axis.h"

#include "drawing.h"
#include "figures.h"
#include "markup.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr double kWidth = 360.0, kHeight = 170.0;
constexpr double kLeft = 46.0, kRight = 10.0, kTop = 8.0, kBottom = 32.0;
constexpr double kFine = 10.0;    // path coordinates are tenths of a unit of the picture
constexpr double kDecades = 2.0;  // curves that span more get a logarithmic axis

struct Panel {
  double x_low = 0.0, x_high = 1.0, y_low = 0.0, y_high = 1.0;
  bool logarithmic = false;

  double x(double value) const {
    return kLeft + (kWidth - kLeft - kRight) * (value - x_low) / (x_high - x_low);
  }
  double y(double value) const {
    const double at = logarithmic ? std::log10(value) : value;
    return kHeight - kBottom - (kHeight - kTop - kBottom) * (at - y_low) / (y_high - y_low);
  }
  bool shows(const Vector2& point) const {
    return is_usable(point.x) && is_usable(point.y) && (!logarithmic || point.y > 0.0);
  }
};

Panel panel_for(const std::vector<const Curve*>& curves) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Panel panel;
  double least_positive = kInfinite;
  panel.x_low = panel.y_low = kInfinite;
  panel.x_high = panel.y_high = -kInfinite;
  for (const Curve* curve : curves) {
    for (const Vector2& point : curve->points) {
      if (!is_usable(point.x) || !is_usable(point.y)) {
        continue;
      }
      panel.x_low = std::min(panel.x_low, point.x);
      panel.x_high = std::max(panel.x_high, point.x);
      panel.y_low = std::min(panel.y_low, point.y);
      panel.y_high = std::max(panel.y_high, point.y);
      if (point.y > 0.0) {
        least_positive = std::min(least_positive, point.y);
      }
    }
  }
  if (panel.y_low >= 0.0 && panel.y_high > 0.0 &&
      std::log10(panel.y_high / least_positive) > kDecades) {
    panel.logarithmic = true;
    panel.y_low = std::floor(std::log10(least_positive));
    panel.y_high = std::ceil(std::log10(panel.y_high));
  } else if (panel.y_low >= 0.0) {
    panel.y_low = 0.0;
  }
  if (!(panel.x_high > panel.x_low)) {
    panel.x_high = panel.x_low + 1.0;
  }
  if (!(panel.y_high > panel.y_low)) {
    panel.y_high = panel.y_low + 1.0;
  }
  return panel;
}

std::string n(double value) { return fixed_text(value, 1); }

std::string superscript(int number) {
  static const char* const kDigits[] = {
      "\xe2\x81\xb0", "\xc2\xb9",     "\xc2\xb2",     "\xc2\xb3",     "\xe2\x81\xb4",
      "\xe2\x81\xb5", "\xe2\x81\xb6", "\xe2\x81\xb7", "\xe2\x81\xb8", "\xe2\x81\xb9"};
  std::string text = number < 0 ? "\xe2\x81\xbb" : "";
  for (const char digit : std::to_string(std::abs(number))) {
    text += kDigits[digit - '0'];
  }
  return text;
}

std::string axes(const Panel& panel, const Curve& about) {
  std::string lines = "<g class=\"grid\">", labels = "<g class=\"axis\">";
  const auto mark_y = [&](double pixel, const std::string& text) {
    lines += "<line x1=\"" + n(kLeft) + "\" x2=\"" + n(kWidth - kRight) + "\" y1=\"" + n(pixel) +
             "\" y2=\"" + n(pixel) + "\"/>";
    labels += "<text class=\"last\" x=\"" + n(kLeft - 6.0) + "\" y=\"" + n(pixel + 3.5) + "\">" +
              text + "</text>";
  };
  if (panel.logarithmic) {
    const int low = static_cast<int>(panel.y_low), high = static_cast<int>(panel.y_high);
    const int step = std::max(1, (high - low + 4) / 5);
    for (int power = low; power <= high; power += step) {
      mark_y(panel.y(std::pow(10.0, power)), "10" + superscript(power));
    }
  } else {
    const picture::Ticks ticks = picture::nice_ticks(panel.y_low, panel.y_high, 4);
    for (const double tick : ticks.at) {
      mark_y(panel.y(tick), picture::tick_label(tick, ticks.step));
    }
  }
  const picture::Ticks ticks = picture::nice_ticks(panel.x_low, panel.x_high, 3);
  for (const double tick : ticks.at) {
    const bool last = panel.x(tick) > kWidth - kRight - 20.0;
    labels += "<text" + std::string(last ? " class=\"last\"" : "") + " x=\"" + n(panel.x(tick)) +
              "\" y=\"" + n(kHeight - kBottom + 14.0) + "\">" +
              picture::tick_label(tick, ticks.step) + "</text>";
  }
  labels += "<text class=\"last\" x=\"" + n(kWidth - kRight) + "\" y=\"" + n(kHeight - 4.0) +
            "\">" + escaped(output::shortened(about.x_label, 50)) + "</text>";
  return lines + "</g>" + labels + "</g>";
}

std::string curve_data(const Panel& panel, const Curve& curve) {
  std::vector<Vector2> points;
  for (const Vector2& point : curve.points) {
    points.push_back(panel.shows(point)
                         ? Vector2{kFine * panel.x(point.x), kFine * panel.y(point.y)}
                         : Vector2{std::nan(""), 0.0});
  }
  std::string data;
  for (const auto& piece : pieces(points)) {
    data += path_data(simplified(piece, 0.4 * kFine));
  }
  return data;
}

}  // namespace

std::string curve_figures(const Findings& findings, std::size_t cell,
                          const std::vector<Curve>& curves, const Inks& inks) {
  std::map<std::int64_t, bool> in_sample;
  for (const std::size_t run : findings.cells[cell].runs) {
    in_sample[findings.results.runs[run].id] = true;
  }
  std::map<std::tuple<std::string, std::string, std::string>, std::vector<const Curve*>> panels;
  for (const Curve& curve : curves) {
    if (!in_sample.contains(curve.run) || curve.points.empty()) {
      continue;
    }
    panels[{curve.robot, curve.plugin, curve.name}].push_back(&curve);
  }
  std::string text;
  for (const auto& [what, all] : panels) {
    const Panel panel = panel_for(all);
    std::map<std::string, std::vector<const Curve*>> alike;  // by their path data
    for (const Curve* curve : all) {
      alike[curve_data(panel, *curve)].push_back(curve);
    }
    alike.erase("");
    const auto& [robot, plugin, name] = what;
    const std::string about = name + (all.front()->y_label.empty() || all.front()->y_label == name
                                          ? ""
                                          : ": " + all.front()->y_label);
    text += "<figure class=\"curves " + inks.cell_class(cell) +
            "\"><figcaption><b>Learning</b> "
            "<span>" +
            escaped(plugin + " of " + robot + ", " + about) +
            "</span></figcaption><svg role=\"img\" aria-label=\"Learning curves\" viewBox=\"0 0 " +
            n(kWidth) + " " + n(kHeight) + "\">" + axes(panel, *all.front()) +
            "<g transform=\"scale(.1)\">";
    for (const auto& [data, same] : alike) {
      std::string title = same.size() == 1 ? "run " + std::to_string(same.front()->run)
                                           : counted(same.size(), "run");
      text += "<path class=\"curve\" d=\"" + data + "\"><title>" + title + "</title></path>";
    }
    text += "</g></svg><small>" +
            (alike.size() == 1 && all.size() > 1 ? counted(all.size(), "run") + ", all alike"
                                                 : counted(all.size(), "run")) +
            "</small></figure>\n";
  }
  return text;
}

}  // namespace elsie::report
