#include <algorithm>
#include <cmath>

#include "elsie/picture/svg.h"

#include "figures.h"
#include "markup.h"
#include "numbers.h"

namespace elsie::report {

namespace {

constexpr double kRow = 52.0;      // height of a cell's row: its label, and below it the box
constexpr double kLabelAt = 15.0;  // base line of the label in the row
constexpr double kMiddle = 30.0;   // of the box in the row
constexpr double kHalfBox = 6.5;
constexpr double kAxis = 20.0;      // height of the labels of an axis
constexpr std::size_t kLabel = 46;  // characters of a label
constexpr std::size_t kRowsInSight = 10;
// With more dots than these on a page, dots have no tooltips, and some are left out.
constexpr std::size_t kDotsWithText = 6000;
constexpr std::size_t kDots = 30000;

std::string y(double value) { return picture::short_number(value, 1); }

std::string percent(double part) { return picture::short_number(100.0 * part, 2) + '%'; }

// The offset of the i-th dot of a row from its middle, in [-1, 1]: the sequence of van der Corput
// (1935) spreads any number of dots evenly.
double jitter(std::size_t i) {
  double part = 0.0, weight = 0.5;
  for (std::size_t rest = i + 1; rest > 0; rest /= 2, weight *= 0.5) {
    part += weight * static_cast<double>(rest % 2);
  }
  return 2.0 * part - 1.0;
}

std::string with_unit(double value, const std::string& unit) {
  return brief(value, 6) + (unit.empty() ? "" : " " + escaped(unit));
}

std::string dots(const Findings& findings, const CellFindings& cell, std::size_t measure,
                 const Span& span, double middle, std::size_t all) {
  const Results& results = findings.results;
  const std::size_t place = findings.measures[measure];
  std::string text;
  std::size_t count = 0;
  for (const std::size_t at : cell.runs) {
    const Run& run = results.runs[at];
    if (run.state != RunState::done || !run.values[place] || !is_usable(*run.values[place])) {
      continue;
    }
    const double value = *run.values[place];
    const double high = middle + 5.0 * jitter(count++);
    const bool outside = cell.measures[measure].stands_out(value);
    if (all > kDots && !findings.missed(run) && !outside) {
      continue;
    }
    const std::string title = all > kDotsWithText
                                  ? ""
                                  : "<title>run " + std::to_string(run.id) + ", seed " +
                                        std::to_string(run.seed) + ": " +
                                        with_unit(value, results.measures[place].unit) + "</title>";
    if (!findings.missed(run)) {
      text += "<circle cx=\"" + span.at(value) + "\" cy=\"" + y(high) + "\" r=\"2.2\"" +
              (outside ? " class=\"odd\"" : "") +
              (title.empty() ? "/>" : ">" + title + "</circle>");
    } else {
      text += "<svg x=\"" + span.at(value) + "\" y=\"" + y(high) + "\">" +
              (outside ? "<circle r=\"5.5\" class=\"ring\"/>" : "") +
              "<path class=\"miss\" d=\"M-3-3 3 3M-3 3 3-3\">" + title + "</path></svg>";
    }
  }
  return text;
}

// Around the height `middle`.
std::string line(const std::string& kind, const Span& span, double from, double to, double middle,
                 double half = 0.0) {
  return "<line class=\"" + kind + "\" x1=\"" + span.at(from) + "\" x2=\"" + span.at(to) +
         "\" y1=\"" + y(middle - half) + "\" y2=\"" + y(middle + half) + "\"/>";
}

std::string box(const MeasureFindings& found, const Span& span, double middle) {
  std::vector<double> sorted = found.values;
  std::sort(sorted.begin(), sorted.end());
  const Interval ends = found.fences ? whiskers(sorted, *found.fences)
                                     : Interval{found.all->least, found.all->largest};
  std::string text;
  if (found.values.size() >= kFewest) {
    text += line("whisker", span, ends.low, ends.high, middle);
    text += "<rect class=\"quartiles\" x=\"" + span.at(found.all->lower_quartile) + "\" y=\"" +
            y(middle - kHalfBox) + "\" width=\"" +
            span.width(found.all->lower_quartile, found.all->upper_quartile) + "\" height=\"" +
            y(2.0 * kHalfBox) + "\" rx=\"2\"/>";
    text += line("median", span, found.all->median, found.all->median, middle, kHalfBox);
  }
  return text;
}

std::string mean_mark(const MeasureFindings& found, const Span& span, double below) {
  return (found.interval ? line("interval", span, found.interval->low, found.interval->high, below)
                         : "") +
         "<svg x=\"" + span.at(found.all->mean) + "\" y=\"" + y(below) +
         "\"><path class=\"mean\" d=\"M0-3.6 3.6 0 0 3.6-3.6 0z\"/></svg>";
}

}  // namespace

double Span::part(double value) const {
  const double inside = (std::clamp(value, low_, high_) - low_) / (high_ - low_);
  return margin_ + (1.0 - 2.0 * margin_) * inside;
}

std::string Span::at(double value) const { return percent(part(value)); }

std::string Span::width(double from, double to) const { return percent(part(to) - part(from)); }

std::string Span::labels(const picture::Ticks& ticks, double y, const std::string& unit) const {
  std::string text = "<g class=\"axis\">";
  for (const double tick : ticks.at) {
    const char* end = margin_ > 0.0       ? ""
                      : part(tick) < 0.02 ? " class=\"first\""
                      : part(tick) > 0.94 ? " class=\"last\""
                                          : "";
    text += "<text x=\"" + at(tick) + "\" y=\"" + report::y(y) + "\"" + end + ">" +
            ticks.label(tick) + (tick == 0.0 ? unit : "") + "</text>";
  }
  return text + "</g>";
}

Span span_of(double low, double high) {
  if (low >= 0.0 && low < 0.4 * high) {
    low = 0.0;
  }
  const double room = 0.03 * (high - low);
  // If all values are equal, the axis is centred on them.
  const double least = std::max(1e-9, 0.05 * std::max(std::abs(low), std::abs(high)));
  if (low == 0.0 && high == 0.0) {
    return {0.0, 1.0};
  }
  if (high - low < 1e-9 * least) {
    return {low - least, high + least};
  }
  return {low == 0.0 ? 0.0 : low - room, high + room};
}

std::string grid(const Span& span, double top, double bottom, bool labels_above) {
  const picture::Ticks ticks = picture::nice_ticks(span.low(), span.high(), 4);
  std::string text = "<g class=\"grid\">";
  for (const double tick : ticks.at) {
    text += "<line x1=\"" + span.at(tick) + "\" x2=\"" + span.at(tick) + "\" y1=\"" + y(top) +
            "\" y2=\"" + y(bottom) + "\"/>";
  }
  return text + "</g>" + (labels_above ? span.labels(ticks, top - 6.0) : "") +
         span.labels(ticks, bottom + 14.0);
}

std::string box_figure(const Findings& findings, std::size_t measure, const Inks& inks) {
  const Measure& about = findings.results.measures[findings.measures[measure]];
  const std::string name = in_words(about.name, about.unit);
  picture::Interval range;
  for (const CellFindings& cell : findings.cells) {
    for (const double value : cell.measures[measure].values) {
      range.include(value);
    }
  }
  std::string text = "<figure class=\"boxes\"><figcaption><b>" + escaped(name) + "</b>" +
                     (about.unit.empty() ? "" : " <span>" + escaped(about.unit) + "</span>") +
                     "<small>" + escaped(about.meaning) + "</small></figcaption>";
  if (range.empty()) {
    return text + "<p class=\"none\">No run has a value.</p></figure>";
  }
  const Span span = span_of(range.low, range.high);
  const bool above = findings.cells.size() > kRowsInSight;
  const double top = above ? kAxis : 0.0;
  const double bottom = top + kRow * static_cast<double>(findings.cells.size()) + 4.0;
  const std::size_t all = findings.runs() * std::max<std::size_t>(findings.measures.size(), 1);
  text += "<svg class=\"plot\" role=\"img\" aria-label=\"Box plots of " + escaped_attribute(name) +
          "\" width=\"100%\" height=\"" + y(bottom + kAxis) + "\">" +
          grid(span, top, bottom, above);
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const double from = top + kRow * static_cast<double>(i);
    const MeasureFindings& found = findings.cells[i].measures[measure];
    const std::string& label = findings.results.cells[i].label;
    text += "<g class=\"row " + inks.cell_class(i) + "\"><text class=\"name\" x=\"2\" y=\"" +
            y(from + kLabelAt) + "\">" + escaped(output::shortened(label, kLabel)) + "</text>";
    if (found.all) {
      text += box(found, span, from + kMiddle) +
              dots(findings, findings.cells[i], measure, span, from + kMiddle, all) +
              mean_mark(found, span, from + kMiddle + kHalfBox + 4.0);
    } else if (found.censoring) {
      text += dots(findings, findings.cells[i], measure, span, from + kMiddle, all);
    } else {
      text += "<text class=\"none\" x=\"2\" y=\"" + y(from + kMiddle + 4.0) +
              "\">no run has a value</text>";
    }
    text += "</g>";
  }
  return text + "</svg></figure>\n";
}

std::string rate_figure(const Findings& findings, const Inks& inks) {
  const Span span(0.0, 100.0);
  constexpr double kHeight = 22.0;
  std::string text = "<div class=\"rates\">";
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const CellFindings& cell = findings.cells[i];
    const double rate = cell.ended > 0 ? 100.0 * static_cast<double>(cell.successes) /
                                             static_cast<double>(cell.ended)
                                       : 0.0;
    if (!cell.goals) {
      continue;
    }
    text += "<div class=\"rate " + inks.cell_class(i) + "\"><span class=\"label\">" +
            escaped(findings.results.cells[i].label) + "</span><svg class=\"plot\" role=\"img\" " +
            "aria-label=\"" + std::to_string(cell.successes) + " of " + std::to_string(cell.ended) +
            " succeeded\" width=\"100%\" height=\"" + y(kHeight) + "\">" +
            line("track", span, 0.0, 100.0, 11.0);
    if (cell.ended > 0) {
      text += line("reach", span, 100.0 * cell.success.low, 100.0 * cell.success.high, 11.0) +
              "<circle cx=\"" + span.at(rate) + "\" cy=\"11\" r=\"5\"/>";
    }
    text +=
        "</svg><span class=\"count\">" + std::to_string(cell.successes) + "<i>/" +
        std::to_string(cell.ended) + "</i></span>" +
        (cell.complete() ? ""
                         : "<em class=\"tag\">" + std::to_string(cell.pending) + " to do</em>") +
        "</div>";
  }
  return text +
         "<div class=\"rate scale\"><span></span><svg class=\"plot\" aria-hidden=\"true\" "
         "width=\"100%\" height=\"16\">" +
         span.labels({{0.0, 25.0, 50.0, 75.0, 100.0}, 25.0}, 12.0) +
         "</svg><span class=\"count\">%</span></div></div>\n";
}

}  // namespace elsie::report
