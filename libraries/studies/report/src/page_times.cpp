// Times: until the goals are reached, and what happened over time.
#include <cmath>

#include "charts.h"
#include "markup.h"
#include "numbers.h"
#include "page.h"

namespace elsie::report {

namespace {

constexpr picture::Size kSurvivalSize{360, 0};
constexpr picture::Size kSeriesSize{360, 250};
constexpr std::size_t kChartsAtOnce = 12;

constexpr const char* kSurvivalLead =
    "The part of the runs that has not reached its goals yet (Kaplan and Meier), with 95\xc2\xa0% "
    "intervals (Greenwood, of log(\xe2\x88\x92log)). A stroke is where the time limit stopped "
    "runs. A run that failed never reaches its goals, and stays at risk to the end. Runs that "
    "ended abnormally are left out.";
constexpr const char* kSeriesLead =
    "Median and quartiles of the runs. A run that is over keeps its last value.";

std::string median_text(const SurvivalCurve& curve) {
  return curve.median ? brief(*curve.median) : "longer than " + brief(curve.steps.back().time);
}

std::string interval_text(const SurvivalCurve& curve) {
  if (!curve.median_interval) {
    return "\xe2\x80\x93";
  }
  return brief(curve.median_interval->low) +
         (std::isfinite(curve.median_interval->high)
              ? "\xc2\xa0\xe2\x80\x93\xc2\xa0" + brief(curve.median_interval->high)
              : " or more");
}

std::string median_table(const Findings& findings) {
  std::vector<std::vector<std::string>> rows{
      {"cell", "runs", "reached", "median s", "95 % interval s"}};
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const std::vector<Observed> times = times_to_goals(findings, i);
    if (times.empty()) {
      continue;
    }
    const SurvivalCurve curve = survival_of(times, kConfidence);
    std::size_t reached = 0;
    for (const SurvivalStep& step : curve.steps) {
      reached += step.events;
    }
    rows.push_back({findings.results.cells[i].label, std::to_string(times.size()),
                    std::to_string(reached), median_text(curve), interval_text(curve)});
  }
  return "<details class=\"fold\"><summary>Medians of the cells</summary>" + html_table(rows, 1) +
         "<p class=\"quiet\">Interval of the median: Brookmeyer and Crowley (1982), from the "
         "intervals of the curve.</p></details>";
}

std::string folded_charts(const std::vector<std::string>& figures) {
  std::string shown, others;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    (i < kChartsAtOnce ? shown : others) += figures[i];
  }
  return "<div class=\"charts\">" + shown + "</div>" +
         (others.empty() ? ""
                         : "<details class=\"fold\"><summary>" +
                               counted(figures.size() - kChartsAtOnce, "more figure") +
                               "</summary><div class=\"charts\">" + others + "</div></details>");
}

}  // namespace

std::string time_sections(const PageContext& page) {
  const Findings& findings = page.findings;
  if (findings.cells.size() > kMostRows) {
    return "";
  }
  std::string text;
  if (any_cut_off(findings)) {
    std::vector<std::string> figures;
    for (const Chart& chart : survival_charts(findings, page.inks)) {
      figures.push_back(chart_figure(chart, kSurvivalSize));
    }
    text += "<section id=\"survival\"><h2>Time until the goals</h2><p class=\"lead\">" +
            std::string(kSurvivalLead) + "</p>" + folded_charts(figures) + median_table(findings) +
            "</section>\n";
  }
  std::vector<std::string> series;
  for (const Chart& chart : series_charts(findings, page.file, page.inks)) {
    series.push_back(chart_figure(chart, kSeriesSize));
  }
  if (!series.empty()) {
    text += "<section id=\"series\"><h2>Over time</h2><p class=\"lead\">" +
            std::string(kSeriesLead) + "</p>" + folded_charts(series) + "</section>\n";
  }
  return text;
}

}  // namespace elsie::report
