// The comparison of the cells.
#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

#include "copies.h"
#include "markup.h"
#include "numbers.h"
#include "page.h"
#include "words.h"

namespace elsie::report {

namespace {

constexpr const char* kSuccessLead =
    "Runs that reached their goals, of those that ended; the bar is Wilson\xe2\x80\x99s "
    "95\xc2\xa0% interval.";
constexpr const char* kNoBarsLead =
    "The number of runs that reached their goals is in the comparison below: there are too many "
    "cells for a figure.";
constexpr const char* kNoGoalsLead =
    "No world of this experiment has goals, so a run can neither succeed nor fail.";
constexpr const char* kTableLead =
    "Mean \xc2\xb1 standard deviation over the runs that ended normally; below, the "
    "95\xc2\xa0% interval of the mean. n: number of runs with a value, where others "
    "have none. &gt;: stopped by the time limit, so that the time is at least this; failed: "
    "never reached its goals.";
constexpr const char* kNoValues =
    "No run that ended normally has a value: there is nothing to compare but success.";
constexpr const char* kBoxesLead =
    "A dot is a run, a cross is a run without success. The box has the middle half of the runs, "
    "its line is the median; whiskers go to the farthest run within 1.5 box lengths; runs with a "
    "ring are beyond. The diamond is the mean, with its 95\xc2\xa0% interval. For failed or "
    "timed-out runs the dot is a lower bound; such cells have no box or mean.";

constexpr picture::Size kRateSize{460, 0};
constexpr picture::Size kBoxSize{360, 0};
// Box plots of further measures are folded.
constexpr std::size_t kFiguresAtOnce = 6;
// Figures with more rows are also folded: the table gives the same numbers in less space.
constexpr std::size_t kRowsAtOnce = 40;
constexpr std::size_t kHeadLength = 40;  // of a column, in characters

bool has_figures(const Findings& findings) { return findings.cells.size() <= kMostRows; }

std::string folded(const Findings& findings, const std::string& figures) {
  const std::size_t cells = findings.cells.size();
  if (cells <= kRowsAtOnce) {
    return figures;
  }
  return "<details class=\"fold\"><summary>Figures of all " + std::to_string(cells) +
         " cells</summary>" + figures + "</details>";
}

std::string ink_key(const PageContext& page) {
  if (!page.inks.factor) {
    return "";
  }
  std::string text =
      "<ul class=\"key\"><li class=\"of\">" +
      escaped(files::shortened(page.findings.results.factors[*page.inks.factor].name, 40)) +
      "</li>";
  for (std::size_t i = 0; i < page.inks.levels.size(); ++i) {
    text += "<li><i class=\"swatch c" + std::to_string(i) + "\"></i>" +
            escaped(files::shortened(page.inks.levels[i], 40)) + "</li>";
  }
  return text + "</ul>";
}

// The heading of the column of labels: the factors that differ between cells.
std::string label_head(const Results& results) {
  std::string text;
  for (std::size_t i = 0; i < results.factors.size(); ++i) {
    std::set<std::string> levels;
    for (const CellInfo& cell : results.cells) {
      levels.insert(cell.levels[i]);
    }
    if (levels.size() > 1) {
      text += (text.empty() ? "" : ", ") + files::shortened(results.factors[i].name, kHeadLength);
    }
  }
  return text.empty() ? "cell" : text;
}

std::string swatch(const PageContext& page, std::size_t cell) {
  if (!page.inks.factor) {
    return "";
  }
  return "<i class=\"swatch " + page.inks.cell_class(cell) + "\"></i>";
}

std::string head(const std::string& text, const std::string& unit, bool number,
                 const std::string& meaning) {
  return "<th" + std::string(number ? " class=\"n\"" : "") + " scope=\"col\"" +
         (meaning.empty() ? "" : " title=\"" + escaped_attribute(meaning) + "\"") + ">" +
         escaped(text) + (unit.empty() ? "" : " <span>" + escaped(unit) + "</span>") + "</th>";
}

std::string value_cell(const CellFindings& of, const MeasureFindings& found,
                       std::optional<int> decimals) {
  const std::string count = found.values.size() < of.ended
                                ? "<small>n " + std::to_string(found.values.size()) + "</small>"
                                : "";
  if (found.censoring) {
    return "<td class=\"n\" data-v=\"" + number_text(found.censoring->median.value_or(1e300)) +
           "\"><b>" + escaped(censored_in_words(found, decimals)) + "</b>" + count + "</td>";
  }
  if (!found.all) {
    return "<td class=\"n none\" data-v=\"\">\xe2\x80\x93</td>";
  }
  const MeanText text = mean_text(*found.all, found.interval, decimals);
  std::string cell =
      "<td class=\"n\" data-v=\"" + number_text(found.all->mean) + "\"><b>" + text.mean + "</b>";
  if (!text.deviation.empty()) {
    cell += " <span>\xc2\xb1\xc2\xa0" + text.deviation + "</span>";
  }
  if (!text.low.empty()) {
    cell += "<small>" + text.low + "\xc2\xa0\xe2\x80\x93\xc2\xa0" + text.high + "</small>";
  }
  return cell + count + "</td>";
}

std::string success_cell(const CellFindings& cell) {
  if (!cell.goals) {
    return "<td class=\"n none\" data-v=\"\">no goals</td>";
  }
  const double rate =
      cell.ended > 0 ? static_cast<double>(cell.successes) / static_cast<double>(cell.ended) : 0.0;
  return "<td class=\"n\" data-v=\"" + number_text(rate) + "\"><b>" +
         std::to_string(cell.successes) + "</b><span>/" + std::to_string(cell.ended) + "</span>" +
         (cell.ended == 0 ? ""
                          : "<small>" + fixed_text(100.0 * cell.success.low, 0) +
                                "\xc2\xa0\xe2\x80\x93\xc2\xa0" +
                                fixed_text(100.0 * cell.success.high, 0) + "\xc2\xa0%</small>") +
         "</td>";
}

std::string table(const PageContext& page) {
  const Findings& findings = page.findings;
  const Results& results = findings.results;
  std::vector<std::optional<int>> decimals;
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    decimals.push_back(decimals_of(findings, i));
  }
  std::string text = "<div class=\"scroll\"><table class=\"sortable filtered\"><thead><tr>";
  text += head(label_head(results), "", false, "");
  text += head("success", "", true, "runs that reached their goals, of those that ended");
  if (findings.broken() > 0) {
    text += head("failed", "", true, "runs that ended abnormally");
  }
  if (findings.pending() > 0) {
    text += head("to do", "", true, "runs that are still to be done");
  }
  for (const std::size_t place : findings.measures) {
    const Measure& measure = results.measures[place];
    text += head(files::shortened(in_words(measure.name, measure.unit), kHeadLength),
                 files::shortened(measure.unit, kHeadLength), true, measure.meaning);
  }
  text += "</tr></thead><tbody>\n";
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const CellFindings& cell = findings.cells[i];
    const CellInfo& info = results.cells[i];
    text += "<tr data-cell=\"" + escaped_attribute(info.label) + "\">";
    text += "<th scope=\"row\" data-v=\"" + std::to_string(i) + "\">" +
            (page.is_detailed(i) ? "<a href=\"#" + anchor(i) + "\">" + swatch(page, i) +
                                       escaped(info.label) + "</a>"
                                 : swatch(page, i) + escaped(info.label)) +
            "</th>";
    text += success_cell(cell);
    const auto count = [&](std::size_t number) {
      return "<td class=\"n" + std::string(number > 0 ? " bad" : "") + "\" data-v=\"" +
             std::to_string(number) + "\">" + std::to_string(number) + "</td>";
    };
    if (findings.broken() > 0) {
      text += count(cell.broken.size());
    }
    if (findings.pending() > 0) {
      text += count(cell.pending);
    }
    for (std::size_t j = 0; j < cell.measures.size(); ++j) {
      text += value_cell(cell, cell.measures[j], decimals[j]);
    }
    text += "</tr>\n";
  }
  return text + "</tbody></table></div>\n";
}

// The value of a measure that is the same in all runs, and so is not drawn.
std::optional<double> only_value(const Findings& findings, std::size_t measure) {
  std::optional<Interval> range;
  std::size_t count = 0;
  for (const CellFindings& cell : findings.cells) {
    if (cell.measures[measure].censoring) {
      return std::nullopt;
    }
    const auto& all = cell.measures[measure].all;
    if (!all) {
      continue;
    }
    range = range ? Interval{std::min(range->low, all->least), std::max(range->high, all->largest)}
                  : Interval{all->least, all->largest};
    count += all->count;
  }
  return count > 1 && are_equal(range->low, range->high) ? std::optional(range->low) : std::nullopt;
}

bool any_value(const Findings& findings, std::size_t measure) {
  return std::any_of(findings.cells.begin(), findings.cells.end(), [&](const CellFindings& cell) {
    return !cell.measures[measure].values.empty();
  });
}

std::string box_figure(const PageContext& page, std::size_t measure) {
  const Measure& about = page.findings.results.measures[page.findings.measures[measure]];
  const Chart chart = box_chart(page.findings, measure, page.inks, 0, page.findings.cells.size());
  std::string head = "<b>" + escaped(in_words(about.name, about.unit)) + "</b>" +
                     (about.unit.empty() ? "" : " <span>" + escaped(about.unit) + "</span>") +
                     "<small>" + escaped(about.meaning) + "</small>";
  for (const std::string& note : chart.notes) {
    head += "<small>" + escaped(note) + ".</small>";
  }
  return chart_figure(chart, kBoxSize, head);
}

std::string figures(const PageContext& page) {
  const Findings& findings = page.findings;
  const bool several =
      std::any_of(findings.cells.begin(), findings.cells.end(), [](const CellFindings& cell) {
        return std::any_of(cell.measures.begin(), cell.measures.end(),
                           [](const MeasureFindings& found) { return found.values.size() > 1; });
      });
  if (findings.measures.empty() || (findings.cells.size() == 1 && !several)) {
    return "";  // the table already has the only value
  }
  if (!has_figures(findings)) {
    return "<section id=\"distributions\"><h2>Distributions</h2><p class=\"quiet\">Box plots are "
           "left out: " +
           std::to_string(findings.cells.size()) +
           " cells are too many for one page.</p></section>\n";
  }
  std::string shown, others, constant, without;
  std::size_t count = 0;
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    const Measure& measure = findings.results.measures[findings.measures[i]];
    if (!any_value(findings, i)) {
      without += (without.empty() ? "" : ", ") + escaped(in_words(measure.name, measure.unit));
      continue;
    }
    if (const auto value = only_value(findings, i)) {
      constant += (constant.empty() ? "" : ", ") + escaped(in_words(measure.name, measure.unit)) +
                  " " + brief(*value) + (measure.unit.empty() ? "" : " " + escaped(measure.unit));
      continue;
    }
    (count++ < kFiguresAtOnce ? shown : others) += box_figure(page, i);
  }
  if (!constant.empty()) {
    constant = "<p class=\"quiet\">The same in every run: " + constant + ".</p>";
  }
  if (!without.empty()) {
    constant += "<p class=\"quiet\">No run has a value: " + without + ".</p>";
  }
  std::string panels = "<div class=\"charts\">" + shown + "</div>";
  if (!others.empty()) {
    panels += "<details class=\"fold\"><summary>" +
              counted(count - kFiguresAtOnce, "more measure") + "</summary><div class=\"charts\">" +
              others + "</div></details>";
  }
  return "<section id=\"distributions\"><h2>Distributions</h2>" +
         (count > 0 ? "<p class=\"lead\">" + std::string(kBoxesLead) + "</p>" +
                          folded(findings, ink_key(page) + panels)
                    : "") +
         constant + "</section>\n";
}

}  // namespace

std::string comparison_sections(const PageContext& page) {
  std::string notes;
  for (std::string note : {one_run_in_words(page.findings), copies_in_words(page.findings)}) {
    if (!note.empty()) {
      note[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(note[0])));
      notes += "<p class=\"quiet\">" + escaped(note) + ".</p>";
    }
  }
  return "<section id=\"success\"><h2>Success</h2><p class=\"lead\">" +
         std::string(!page.findings.any_goals()   ? kNoGoalsLead
                     : has_figures(page.findings) ? kSuccessLead
                                                  : kNoBarsLead) +
         "</p>" +
         (page.findings.any_goals() && has_figures(page.findings)
              ? folded(page.findings,
                       ink_key(page) + chart_figure(rate_chart(page.findings, page.inks, 0,
                                                               page.findings.cells.size()),
                                                    kRateSize))
              : "") +
         "</section>\n<section id=\"comparison\"><h2>Comparison</h2><p class=\"lead\">" +
         (page.findings.measures.empty() ? kNoValues : kTableLead) + "</p>" + table(page) + notes +
         "</section>\n" + figures(page);
}

}  // namespace elsie::report
