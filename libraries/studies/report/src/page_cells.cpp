// A section for each cell.
#include <algorithm>
#include <map>
#include <set>

#include "elsie/process/shell_word.h"

#include "markup.h"
#include "numbers.h"
#include "page.h"
#include "words.h"

namespace elsie::report {

namespace {

// With more cells than this, cells are folded.
constexpr std::size_t kOpenCells = 12;
constexpr std::size_t kHeadMeasures = 3;
constexpr picture::Size kDecisionSize{430, 0};
constexpr picture::Size kCurveSize{420, 190};
// Number of notable runs that are shown; the others are folded.
constexpr std::size_t kRunsAtOnce = 8;

// What is known of a measure, from the number of its runs to the largest value.
std::vector<std::string> numbers_of(const MeasureFindings& found, bool some_missed) {
  constexpr const char* kNone = "\xe2\x80\x93";
  const auto& known = found.all ? found.all : found.successes;
  const double limit = found.censoring ? found.censoring->limit.value_or(0.0) : 0.0;
  const std::optional<int> decimals =
      known ? decimals_for(known->mean, known->standard_deviation.value_or(0.0))
            : decimals_for(limit, 0.0);
  const auto number = [&](std::optional<double> value) -> std::string {
    return !value ? kNone : decimals ? fixed_text(*value, *decimals) : brief(*value);
  };
  std::vector<std::string> texts{std::to_string(found.values.size())};
  if (found.censoring) {
    const Censoring& censoring = *found.censoring;
    const std::string bound = censoring.limit ? ">\xc2\xa0" + number(limit) : "never";
    const auto or_bound = [&](const std::optional<double>& value) {
      return value ? number(value) : bound;
    };
    texts.insert(texts.end(),
                 {kNone, kNone, kNone, or_bound(censoring.least), kNone, or_bound(censoring.median),
                  kNone, censoring.failures > 0 ? "never" : bound});
  } else if (found.all) {
    const Summary& all = *found.all;
    const MeanText mean = mean_text(all, found.interval);
    texts.insert(texts.end(),
                 {number(all.mean), number(all.standard_deviation),
                  mean.low.empty() ? kNone : mean.low + "\xc2\xa0\xe2\x80\x93\xc2\xa0" + mean.high,
                  number(all.least), number(all.lower_quartile), number(all.median),
                  number(all.upper_quartile), number(all.largest)});
  }
  if (some_missed && texts.size() > 1) {
    texts.push_back(number(found.successes ? std::optional(found.successes->mean) : std::nullopt));
  }
  return texts;
}

std::string measure_table(const PageContext& page, const CellFindings& cell) {
  const bool some_missed =
      std::any_of(cell.measures.begin(), cell.measures.end(), [&](const MeasureFindings& found) {
        return cell.goals && !found.values.empty() &&
               (!found.successes || found.successes->count < found.values.size());
      });
  std::vector<std::vector<std::string>> rows{{"measure", "runs", "mean", "std. deviation",
                                              "95\xc2\xa0% interval", "least", "lower quartile",
                                              "median", "upper quartile", "largest"}};
  if (some_missed) {
    rows[0].emplace_back("mean of successes");
  }
  for (std::size_t i = 0; i < cell.measures.size(); ++i) {
    const Measure& measure = page.findings.results.measures[page.findings.measures[i]];
    rows.push_back(numbers_of(cell.measures[i], some_missed));
    rows.back().insert(rows.back().begin(),
                       in_words(measure.name, measure.unit) +
                           (measure.unit.empty() ? "" : " (" + measure.unit + ")"));
  }
  return "<details class=\"numbers\"><summary>All numbers</summary>" + html_table(rows, 1) +
         "</details>\n";
}

// The reasons why runs are notable, by index, in the order in which they are shown.
std::vector<std::pair<std::size_t, std::string>> notable_runs(const Findings& findings,
                                                              const CellFindings& cell) {
  std::vector<std::size_t> order = cell.broken;
  std::map<std::size_t, std::string> outliers;
  for (const Outlier& outlier : cell.outliers) {
    const Measure& measure = findings.results.measures[outlier.measure];
    std::string& text = outliers[outlier.run];
    text += (text.empty() ? "outlier: " : ", ") + in_words(measure.name, measure.unit) + " " +
            brief(outlier.value, 5) + (measure.unit.empty() ? "" : " " + measure.unit);
    order.push_back(outlier.run);
  }
  for (const std::size_t place : cell.runs) {
    const Run& run = findings.results.runs[place];
    if (findings.missed(run)) {
      order.push_back(place);
    }
  }
  std::vector<std::pair<std::size_t, std::string>> notable;
  std::set<std::size_t> seen;
  for (const std::size_t place : order) {
    if (!seen.insert(place).second) {
      continue;
    }
    const Run& run = findings.results.runs[place];
    std::string text = run.broken() ? circumstances(run) : findings.missed(run) ? run.message : "";
    if (text.ends_with('.')) {
      text.pop_back();
    }
    if (const auto odd = outliers.find(place); odd != outliers.end()) {
      text += (text.empty() ? "" : "; ") + odd->second;
    }
    notable.emplace_back(place, text);
  }
  return notable;
}

std::string run_table(const PageContext& page, const CellFindings& cell) {
  const auto notable = notable_runs(page.findings, cell);
  if (notable.empty()) {
    return "<p class=\"quiet\">" +
           std::string(cell.ended == 0 ? "No run is done yet." : "No run stands out.") + "</p>\n";
  }
  std::string shown, folded;
  // If only one run would be folded, it is shown instead.
  const std::size_t most = notable.size() == kRunsAtOnce + 1 ? notable.size() : kRunsAtOnce;
  for (std::size_t i = 0; i < notable.size(); ++i) {
    const Run& run = page.findings.results.runs[notable[i].first];
    (i < most ? shown : folded) +=
        run_row(page, run, ending_tag(page.findings, run), escaped(notable[i].second));
  }
  return "<h4>Runs to look at</h4>" + runs_table("ended", "why", shown) +
         (folded.empty() ? ""
                         : "<details class=\"fold\"><summary>" +
                               counted(notable.size() - most, "more", "more") + "</summary>" +
                               runs_table("ended", "why", folded) + "</details>");
}

std::string headline(const PageContext& page, std::size_t place) {
  const CellFindings& cell = page.findings.cells[place];
  const std::string swatch =
      page.inks.factor ? "<i class=\"swatch " + page.inks.cell_class(place) + "\"></i>" : "";
  std::string text = "<h3>" + swatch + escaped(page.findings.results.cells[place].label) +
                     "</h3><p class=\"facts\"><span>" +
                     (cell.goals ? "<b>" + std::to_string(cell.successes) + "</b>/" +
                                       std::to_string(cell.ended) + " success"
                                 : "no goals") +
                     "</span>";
  if (!cell.broken.empty()) {
    text += "<span class=\"bad\"><b>" + std::to_string(cell.broken.size()) + "</b> failed</span>";
  }
  if (cell.pending > 0) {
    text += "<span class=\"bad\"><b>" + std::to_string(cell.pending) + "</b> to do</span>";
  }
  for (std::size_t i = 0; i < std::min(kHeadMeasures, cell.measures.size()); ++i) {
    const MeasureFindings& found = cell.measures[i];
    const Measure& measure = page.findings.results.measures[page.findings.measures[i]];
    if (found.censoring) {
      text += "<span>" + escaped(in_words(measure.name, measure.unit)) + " <b>" +
              escaped(censored_in_words(found, decimals_of(page.findings, i))) + "</b>" +
              (measure.unit.empty() ? "" : " " + escaped(measure.unit)) + "</span>";
    }
    if (!found.all) {
      continue;
    }
    const MeanText mean = mean_text(*found.all, found.interval);
    text += "<span>" + escaped(in_words(measure.name, measure.unit)) + " <b>" + mean.mean + "</b>" +
            (mean.deviation.empty() ? "" : " \xc2\xb1 " + mean.deviation) +
            (measure.unit.empty() ? "" : " " + escaped(measure.unit)) +
            (found.all->count < cell.ended ? " (n " + std::to_string(found.all->count) + ")" : "") +
            "</span>";
  }
  return text + "</p>";
}

// The number of cells without a section, and how to see them.
std::string left_out(const PageContext& page) {
  const std::size_t all = page.findings.cells.size(), shown = page.detailed.size();
  if (shown == all) {
    return "";
  }
  return "<p class=\"lead\">" + std::to_string(shown) + " of " + counted(all, "cell") +
         (shown == 1 ? " is" : " are") + " drawn here. <code>elsie report " +
         escaped(process::shell_word(page.database)) +
         " --html FILE.html --cells TEXT</code> draws those whose names have the text in "
         "them.</p>\n";
}

std::string head_of(const std::string& what, const std::vector<std::string>& notes) {
  return "<b>" + escaped(what) + "</b> <span>" + escaped(notes.front()) + "</span>";
}

}  // namespace

std::string cell_sections(const PageContext& page) {
  const Findings& findings = page.findings;
  const bool folded = page.detailed.size() > kOpenCells;
  const Budget budget = budget_for(page.detailed.size());
  std::string text = "<section id=\"cells\"><h2>Cells</h2>\n" + left_out(page);
  for (const std::size_t i : page.detailed) {
    const CellInfo& info = findings.results.cells[i];
    std::string beside;
    for (const Chart& chart :
         decision_charts(findings, i, page.file.timelines(info.id), page.inks, budget.rows)) {
      beside += chart_figure(chart, kDecisionSize, head_of("Who decided when", chart.notes));
    }
    for (const Chart& chart : learning_charts(findings, i, page.file.curves(info.id))) {
      beside += chart_figure(chart, kCurveSize, head_of(chart.caption, chart.notes));
    }
    const std::string map =
        map_figure(findings, i, page.file.trajectories(info.id), page.inks, budget);
    text += "<article class=\"cell\" id=\"" + anchor(i) + "\" data-cell=\"" +
            escaped_attribute(info.label) + "\">" +
            (folded ? "<details><summary>" + headline(page, i) + "</summary>" : headline(page, i)) +
            "<div class=\"pictures\">" + map + "<div class=\"beside " + page.inks.cell_class(i) +
            "\">" + (beside.empty() ? run_table(page, findings.cells[i]) : beside) +
            "</div></div>" + (beside.empty() ? "" : run_table(page, findings.cells[i])) +
            measure_table(page, findings.cells[i]) + (folded ? "</details>" : "") + "</article>\n";
  }
  return text + "</section>\n";
}

}  // namespace elsie::report
