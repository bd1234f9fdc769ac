#include "elsie/report/answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/output/clean_text.h"
#include "elsie/process/text_table.h"

#include "numbers.h"

namespace elsie::report {

namespace {

void find_levels(const Findings& findings, const std::vector<std::string>& by, Answers& answers) {
  const std::vector<VariedFactor> factors = varied_factors(findings.results);
  std::vector<std::string> names;
  for (const VariedFactor& factor : factors) {
    names.push_back(factor.name);
  }
  std::vector<const VariedFactor*> chosen;
  for (const std::string& name : by) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) {
      throw std::invalid_argument("no factor '" + output::one_line(name) + "' is varied" +
                                  base::near_or_all(name, names, "there are"));
    }
    const VariedFactor* factor = &factors[static_cast<std::size_t>(found - names.begin())];
    if (std::find(chosen.begin(), chosen.end(), factor) != chosen.end()) {
      throw std::invalid_argument("the factor '" + output::one_line(name) +
                                  "' is named twice; name each once");
    }
    chosen.push_back(factor);
  }
  answers.by = by;
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < findings.cells.size() && !chosen.empty(); ++i) {
    std::vector<std::size_t> levels;
    for (const VariedFactor* factor : chosen) {
      levels.push_back(factor->of_cell[i]);
    }
    cells[levels].push_back(i);
  }
  const std::vector<Response> all = responses(findings);
  for (const auto& [levels, of] : cells) {
    LevelRow row;
    row.cells = of.size();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      row.levels.push_back(chosen[i]->levels[levels[i]]);
    }
    for (const Response& response : all) {
      row.margins.push_back(margin_of(findings, response, of));
    }
    answers.levels.push_back(std::move(row));
  }
}

// Corrects each response over all comparisons that were asked for.
void correct_all(std::vector<std::vector<Contrast>>& comparisons) {
  std::map<std::string, std::vector<Contrast*>> by_response;
  for (std::vector<Contrast>& comparison : comparisons) {
    for (Contrast& one : comparison) {
      by_response[one.response.name].push_back(&one);
    }
  }
  for (const auto& [name, all] : by_response) {
    std::vector<Contrast> together;
    for (const Contrast* one : all) {
      together.push_back(*one);
    }
    correct(together);
    for (std::size_t i = 0; i < all.size(); ++i) {
      *all[i] = together[i];
    }
  }
}

std::string margin_text(const Response& response, const Margin& margin) {
  if (!response.measure) {
    return margin.centre ? fixed_text(100.0 * *margin.centre, 0) + " % (" +
                               fixed_text(100.0 * margin.interval->low, 0) + " to " +
                               fixed_text(100.0 * margin.interval->high, 0) + ")"
                         : "-";
  }
  if (!margin.centre) {
    return margin.cut_off > 0
               ? std::to_string(margin.cut_off) + " of " + std::to_string(margin.runs) + " cut off"
               : "-";
  }
  std::string text = (margin.cut_off > 0 ? "median " : "") + brief(*margin.centre);
  if (margin.interval) {
    text += " (" + brief(margin.interval->low) +
            (std::isfinite(margin.interval->high) ? " to " + brief(margin.interval->high)
                                                  : " or more") +
            ")";
  }
  return text;
}

std::string level_table(const Findings& findings, const Answers& answers) {
  std::vector<std::vector<std::string>> rows{{}};
  for (const std::string& name : answers.by) {
    rows[0].push_back(output::one_line(name));
  }
  rows[0].emplace_back("cells");
  const std::vector<Response> all = responses(findings);
  for (const Response& response : all) {
    rows[0].push_back(output::one_line(response.name));
  }
  for (const LevelRow& level : answers.levels) {
    std::vector<std::string> row;
    for (const std::string& label : level.levels) {
      row.push_back(output::one_line(label));
    }
    row.push_back(std::to_string(level.cells));
    for (std::size_t i = 0; i < all.size(); ++i) {
      row.push_back(margin_text(all[i], level.margins[i]));
    }
    rows.push_back(std::move(row));
  }
  return process::laid_out(rows, answers.by.size(), 3);
}

}  // namespace

Answers answer(const Findings& findings, const Asked& asked) {
  Answers answers;
  find_levels(findings, asked.by, answers);
  for (const auto& [first, second] : asked.compared) {
    answers.comparisons.push_back(compare(findings, first, second));
  }
  correct_all(answers.comparisons);
  for (const std::string& formula : asked.models) {
    answers.models.push_back(factor_model(findings, formula));
  }
  return answers;
}

std::string terminal_answers(const Findings& findings, const Answers& answers) {
  std::string text;
  if (!answers.by.empty()) {
    text += "\nBy factor, over all else\n" + level_table(findings, answers) +
            "\nsuccess: rate of the runs; measures: mean of the seeds, or the median where a limit "
            "cut off values; with 95 % intervals\n";
  }
  for (const std::vector<Contrast>& comparison : answers.comparisons) {
    text += "\nComparison\n" + process::laid_out(contrast_table(comparison, true), 3, 3);
  }
  if (!answers.comparisons.empty()) {
    text +=
        "\np by seed: sign test of success and of times that a limit cut off, else Wilcoxon's\n"
        "signed-rank test; p pooled: Fisher's exact test, or that of Mann and Whitney; both\n"
        "corrected for all comparisons of a measure (Holm)\n";
  }
  for (const FactorModel& model : answers.models) {
    text += "\n" + std::string(model.response.measure ? "Linear" : "Logistic") + " model " +
            output::one_line(model.formula) + "\n" +
            process::laid_out(coefficient_table(model), 1, 3) + fit_in_words(model) + "\n";
    for (const std::string& warning : model.warnings) {
      text += "warning: " + warning + "\n";
    }
  }
  return text;
}

}  // namespace elsie::report
