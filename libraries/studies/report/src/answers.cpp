#include "elsie/report/answers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/files/clean_text.h"
#include "elsie/process/text_table.h"

#include "copies.h"
#include "numbers.h"
#include "words.h"

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
      throw std::invalid_argument("no factor '" + files::one_line(name) + "' is varied" +
                                  base::near_or_all(name, names, "there are"));
    }
    const VariedFactor* factor = &factors[static_cast<std::size_t>(found - names.begin())];
    if (std::find(chosen.begin(), chosen.end(), factor) != chosen.end()) {
      throw std::invalid_argument("the factor '" + files::one_line(name) +
                                  "' is named twice; name each once");
    }
    chosen.push_back(factor);
  }
  answers.by = by;
  std::vector<std::size_t> named;
  for (const VariedFactor* factor : chosen) {
    named.push_back(factor->factor);
  }
  std::map<std::vector<std::size_t>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < findings.cells.size() && !chosen.empty(); ++i) {
    std::vector<std::size_t> levels;
    for (const VariedFactor* factor : chosen) {
      levels.push_back(factor->of_cell[i]);
    }
    cells[levels].push_back(i);
  }
  std::vector<std::vector<std::size_t>> groups;
  for (const auto& [levels, of] : cells) {
    groups.push_back(of);
    LevelRow& row = answers.levels.emplace_back();
    row.cells = of.size();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      row.levels.push_back(chosen[i]->levels[levels[i]]);
    }
  }
  std::vector<std::pair<std::string, std::vector<std::string>>> notes;
  for (const Response& response : responses(findings)) {
    const Balance balance = balanced(findings, response, groups, named);
    for (std::size_t i = 0; i < groups.size(); ++i) {
      answers.levels[i].margins.push_back(margin_of(findings, response, balance, i));
    }
    notes.emplace_back(files::one_line(response.name), notes_on(balance));
  }
  answers.by_notes = gathered(notes);
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
    correct(all);
  }
}

std::string margin_text(const Response& response, const Margin& margin) {
  if (!response.measure) {
    if (!margin.centre) {
      return "-";
    }
    const auto percent = [](double rate) { return fixed_text(100.0 * rate, 0); };
    return percent(*margin.centre) + " %" +
           (margin.interval ? " (" + percent(margin.interval->low) + " to " +
                                  percent(margin.interval->high) + ")"
                            : "");
  }
  if (!margin.centre) {
    return margin.cut_off > 0
               ? std::to_string(margin.cut_off) + " of " + std::to_string(margin.runs) + " cut off"
               : "-";
  }
  std::string text = (margin.median ? "median " : "") + brief(*margin.centre);
  if (margin.interval) {
    text += " (" + brief(margin.interval->low) +
            (std::isfinite(margin.interval->high) ? " to " + brief(margin.interval->high)
                                                  : " or more") +
            ")";
  }
  return text;
}

std::string noted(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) {
    text += "note: " + note + "\n";
  }
  return text;
}

std::string level_table(const Findings& findings, const Answers& answers) {
  std::vector<std::vector<std::string>> rows{{}};
  for (const std::string& name : answers.by) {
    rows[0].push_back(files::one_line(name));
  }
  rows[0].emplace_back("cells");
  const std::vector<Response> all = responses(findings);
  for (const Response& response : all) {
    rows[0].push_back(files::one_line(response.name));
  }
  for (const LevelRow& level : answers.levels) {
    std::vector<std::string> row;
    for (const std::string& label : level.levels) {
      row.push_back(files::one_line(label));
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
            "\nsuccess: rate of the runs; measures: mean of the seeds, or the median of all runs "
            "if some have only a bound; with 95 % intervals\n" +
            noted(answers.by_notes);
  }
  for (const std::vector<Contrast>& comparison : answers.comparisons) {
    text += "\nComparison\n" + process::laid_out(contrast_table(comparison, true), 3, 3) +
            noted(contrast_notes(comparison, true));
  }
  if (!answers.comparisons.empty()) {
    text +=
        "\np by seed: Wilcoxon's signed-rank test; p pooled: Fisher's exact test, or that of Mann\n"
        "and Whitney; both corrected for all comparisons of a measure (Holm). The 95 % intervals\n"
        "are not corrected: each is about one comparison, and of twenty, one misses on average\n";
  }
  for (const FactorModel& model : answers.models) {
    text += "\n" + std::string(model.response.measure ? "Linear" : "Logistic") + " model " +
            files::one_line(model.formula) + "\n" +
            process::laid_out(coefficient_table(model), 1, 3) + fit_in_words(model) + "\n";
    for (const std::string& warning : model.warnings) {
      text += "warning: " + warning + "\n";
    }
  }
  if (text.empty()) {
    return text;
  }
  if (const std::string note = copies_in_words(findings); !note.empty()) {
    text += "\nnote: " + files::one_line(note) + "\n";
  }
  if (!findings.good()) {
    text += "\n" + answer_in_words(findings) + "; the report without questions has the details\n";
  }
  return text.substr(1);  // of the empty line before each part, the first
}

}  // namespace elsie::report
