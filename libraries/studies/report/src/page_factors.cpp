// The results by factor: main effects, two factors together, comparisons, models.
#include <algorithm>
#include <stdexcept>

#include "charts.h"
#include "markup.h"
#include "numbers.h"
#include "page.h"

namespace elsie::report {

namespace {

constexpr picture::Size kEffectSize{360, 230};
constexpr picture::Size kPairSize{360, 0};
// Further measures are folded.
constexpr std::size_t kResponsesAtOnce = 3;

constexpr const char* kFactorsLead =
    "What changes when one factor is varied, over all levels of the others. Points are rates of "
    "success, or means in which each seed counts once, or medians if only a bound is known of "
    "some runs; bars are their 95\xc2\xa0% intervals, with an arrow where the upper end is not "
    "known. The charts of a measure have the same scale, so that the factor with the largest range "
    "matters most.";
constexpr const char* kContrastsNote =
    "The first less the second. <b>By seed</b>: for each seed, the mean difference of cells that "
    "match in all other factors; Wilcoxon\xe2\x80\x99s signed-rank test. <b>Pooled</b>: all runs "
    "against all runs, as if they "
    "were independent; Fisher\xe2\x80\x99s exact test with the odds ratio, or the test of Mann and "
    "Whitney with Cliff\xe2\x80\x99s delta and Hedges\xe2\x80\x99 g. p is corrected for all "
    "comparisons of the measure (Holm). The 95\xc2\xa0% intervals are not corrected: each is about "
    "one comparison, and of twenty, one misses on average.";

std::string charts_in(const std::vector<Chart>& charts, const picture::Size& size) {
  std::string text;
  for (const Chart& chart : charts) {
    text += chart_figure(chart, size);
  }
  return text.empty() ? "" : "<div class=\"charts\">" + text + "</div>";
}

std::string details(const std::string& summary, const std::string& content) {
  return content.empty() ? ""
                         : "<details class=\"fold\"><summary>" + summary + "</summary>" + content +
                               "</details>\n";
}

std::string noted_on_page(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += "<p class=\"bad\">" + escaped(note) + "</p>";
  }
  return text;
}

// Two factors share their notes: the lines and the tiles are of the same runs.
std::vector<std::string> notes_on_charts(const std::vector<Chart>& charts) {
  std::vector<std::pair<std::string, std::vector<std::string>>> notes;
  for (const Chart& chart : charts) {
    const std::string name = chart.caption.substr(0, chart.caption.find(':'));
    if (notes.empty() || notes.back().first != name) {
      notes.emplace_back(name, chart.notes);
    }
  }
  return gathered(notes);
}

std::string model_of(const Findings& findings, const FactorModel& model) {
  std::string text = "<p><code>" + escaped(model.formula) + "</code></p>" +
                     html_table(coefficient_table(model), 1) + "<p class=\"quiet\">" +
                     escaped(fit_in_words(model)) + "</p>";
  text += noted_on_page(model.warnings);
  if (!model.response.measure || findings.cells.size() <= kMostRows) {
    text += charts_in({model_chart(findings, model)}, {420, 260});
  }
  return text;
}

std::string main_model(const Findings& findings, const Response& response) {
  try {
    return model_of(findings, factor_model(findings, main_effects(findings, response)));
  } catch (const std::invalid_argument& error) {
    return "<p class=\"quiet\">No model: " + escaped(error.what()) + ".</p>";
  }
}

std::string response_part(const PageContext& page, const Response& response) {
  const Findings& findings = page.findings;
  const std::string unit =
      response.unit.empty() ? "" : " <span class=\"quiet\">" + escaped(response.unit) + "</span>";
  const std::vector<Contrast> contrasts = level_contrasts(findings, response);
  const std::vector<Chart> pairs = pair_charts(findings, response, page.inks);
  return "<h3>" + escaped(response.words) + unit + "</h3>" +
         charts_in(effect_charts(findings, response), kEffectSize) +
         noted_on_page(notes_on_effects(findings, response)) +
         details("Two factors together",
                 charts_in(pairs, kPairSize) + noted_on_page(notes_on_charts(pairs))) +
         details("Levels compared", contrasts.empty()
                                        ? ""
                                        : html_table(contrast_table(contrasts, false), 2) +
                                              "<p class=\"quiet\">" + kContrastsNote + "</p>" +
                                              noted_on_page(contrast_notes(contrasts, false))) +
         details(response.measure ? "Linear model" : "Logistic model",
                 main_model(findings, response));
}

std::string asked_part(const PageContext& page) {
  std::string text;
  for (const std::vector<Contrast>& comparison : page.answers.comparisons) {
    text += "<h3>" + escaped(comparison.front().first) + " against " +
            escaped(comparison.front().second) + "</h3>" +
            html_table(contrast_table(comparison, true), 3) + "<p class=\"quiet\">" +
            kContrastsNote + "</p>" + noted_on_page(contrast_notes(comparison, true));
  }
  for (const FactorModel& model : page.answers.models) {
    text += "<h3>" + std::string(model.response.measure ? "Linear" : "Logistic") + " model of " +
            escaped(model.response.words) + "</h3>" + model_of(page.findings, model);
  }
  return text.empty() ? ""
                      : "<section id=\"asked\"><h2>What was asked for</h2>" + text + "</section>\n";
}

}  // namespace

std::string chart_figure(const Chart& chart, const picture::Size& size, const std::string& head) {
  return "<figure class=\"chart\">" +
         (head.empty() ? "" : "<figcaption>" + head + "</figcaption>") +
         picture::page_chart(chart.panel, chart.caption, size) + "</figure>\n";
}

std::string html_table(const std::vector<std::vector<std::string>>& rows,
                       std::size_t text_columns) {
  std::string text = "<div class=\"scroll\"><table>";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const char* const tag = i == 0 ? "th" : "td";
    const char* const text_kind = i == 0 ? ">" : " class=\"name\">";
    text += i == 0 ? "<thead><tr>" : "<tr>";
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      text += "<" + std::string(tag) + (j < text_columns ? text_kind : " class=\"n\">") +
              escaped(rows[i][j]) + "</" + tag + ">";
    }
    text += i == 0 ? "</tr></thead><tbody>" : "</tr>";
  }
  return text + "</tbody></table></div>\n";
}

std::string factor_sections(const PageContext& page) {
  if (varied_factors(page.findings.results).empty() || page.findings.ended() == 0) {
    return asked_part(page);
  }
  std::string shown, others, constant;
  std::size_t count = 0;
  for (const Response& response : responses(page.findings)) {
    if (is_constant(page.findings, response)) {
      constant += (constant.empty() ? "" : ", ") + escaped(response.words);
      continue;
    }
    (count++ < kResponsesAtOnce ? shown : others) += response_part(page, response);
  }
  if (!constant.empty()) {
    constant = "<p class=\"quiet\">The same in every run, or in none: " + constant + ".</p>";
  }
  std::string large;
  for (const VariedFactor& factor : varied_factors(page.findings.results)) {
    if (factor.levels.size() > kMostLevels) {
      large += (large.empty() ? "" : ", ") + escaped(files::shortened(factor.name, 40)) + " (" +
               std::to_string(factor.levels.size()) + ")";
    }
  }
  if (!large.empty()) {
    constant +=
        "<p class=\"quiet\">Factors with many levels have no comparisons of these, and "
        "no figures where they are too many: " +
        large + ".</p>";
  }
  return asked_part(page) + "<section id=\"factors\"><h2>By factor</h2><p class=\"lead\">" +
         kFactorsLead + "</p>" + shown +
         (others.empty() ? ""
                         : details(counted(count - kResponsesAtOnce, "more measure"), others)) +
         constant + "</section>\n";
}

}  // namespace elsie::report
