#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/base/utf8.h"
#include "elsie/files/clean_text.h"
#include "elsie/process/text_table.h"
#include "elsie/report/report.h"

#include "copies.h"
#include "effects.h"
#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

constexpr std::size_t kMostRuns = 20;  // failed runs that are listed

using Column = std::vector<std::string>;  // head, then a text for each cell

constexpr std::size_t kGap = 3;  // between two columns

std::size_t width_of(const Column& column) {
  std::size_t width = 0;
  for (const std::string& text : column) {
    width = std::max(width, base::characters(text));
  }
  return width;
}

// The first column is aligned left, the others right.
std::string table(const std::vector<const Column*>& columns) {
  std::vector<std::vector<std::string>> rows(columns.front()->size());
  for (const Column* column : columns) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      rows[row].push_back((*column)[row]);
    }
  }
  return process::laid_out(rows, 1, kGap);
}

constexpr std::size_t kNameLength = 60;

std::string shown_name(const std::string& name) {
  return files::shortened(files::one_line(name), kNameLength);
}

Column labels(const Findings& findings) {
  Column column{"cell"};
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const std::string& label = findings.results.cells[i].label;
    column.push_back(label.empty() ? "all" : short_label(label, kNameLength));
  }
  return column;
}

Column success_column(const Findings& findings) {
  Column column{"success"};
  for (const CellFindings& cell : findings.cells) {
    column.push_back(success_in_words(cell));
  }
  return column;
}

Column measure_column(const Findings& findings, std::size_t place) {
  const Measure& measure = findings.results.measures[findings.measures[place]];
  const std::optional<int> decimals = decimals_of(findings, place);
  Column column{shown_name(measure.name)};
  std::vector<std::string> counts;
  for (const CellFindings& cell : findings.cells) {
    const MeasureFindings& found = cell.measures[place];
    const std::size_t count = found.values.size();
    counts.push_back(count > 0 && count < cell.ended ? " (n " + std::to_string(count) + ")" : "");
    if (found.censoring) {
      column.push_back(censored_in_words(found, decimals));
      continue;
    }
    if (!found.all) {
      column.emplace_back("-");
      continue;
    }
    const MeanText text = mean_text(*found.all, found.interval, decimals);
    column.push_back(text.deviation.empty() ? text.mean : text.mean + " +- " + text.deviation);
  }
  // Aligns the signs, and so the decimal points.
  std::size_t after = 0;
  for (const std::string& text : column) {
    const std::size_t sign = text.find(" +- ");
    if (sign != std::string::npos) {
      after = std::max(after, text.size() - sign);
    }
  }
  for (std::size_t i = 1; i < column.size(); ++i) {
    const std::size_t sign = column[i].find(" +- ");
    const std::size_t length = sign == std::string::npos ? 0 : column[i].size() - sign;
    if (sign != std::string::npos) {
      column[i] += std::string(after - length, ' ');
    }
  }
  std::size_t widest = 0;
  for (const std::string& count : counts) {
    widest = std::max(widest, count.size());
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    column[i + 1] += counts[i] + std::string(widest - counts[i].size(), ' ');
  }
  return column;
}

void add_counts(const Findings& findings, std::vector<Column>& columns) {
  Column broken{"failed"}, pending{"to do"};
  for (const CellFindings& cell : findings.cells) {
    broken.push_back(std::to_string(cell.broken.size()));
    pending.push_back(std::to_string(cell.pending));
  }
  if (findings.broken() > 0) {
    columns.push_back(std::move(broken));
  }
  if (findings.pending() > 0) {
    columns.push_back(std::move(pending));
  }
}

std::string tables(const Findings& findings, std::size_t width) {
  const Column cells = labels(findings);
  std::vector<Column> columns{success_column(findings)};
  add_counts(findings, columns);
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    columns.push_back(measure_column(findings, i));
  }
  std::string text;
  for (std::size_t next = 0; next < columns.size();) {
    std::vector<const Column*> part{&cells};
    std::size_t used = width_of(cells);
    do {
      used += kGap + width_of(columns[next]);
      part.push_back(&columns[next++]);
    } while (next < columns.size() && used + kGap + width_of(columns[next]) <= width);
    text += (text.empty() ? "" : "\n") + table(part);
  }
  return text;
}

// Explains the entries of tables other than means, each by its first example.
std::string legend(const Findings& findings) {
  std::size_t fewer = 0;
  std::optional<double> limit, bound;
  bool failed = false;
  for (const CellFindings& cell : findings.cells) {
    for (std::size_t i = 0; i < cell.measures.size(); ++i) {
      const MeasureFindings& found = cell.measures[i];
      const std::size_t count = found.values.size();
      fewer = fewer == 0 && count < cell.ended ? count : fewer;
      if (found.censoring) {
        const bool time = findings.results.measures[findings.measures[i]].name == kTime;
        std::optional<double>& first = time ? limit : bound;
        first = first ? first : found.censoring->limit;
        failed |= found.censoring->failures > 0;
      }
    }
  }
  std::string text;
  if (fewer > 0) {
    text += "(n " + std::to_string(fewer) + "): over " + counted(fewer, "run") +
            ", as the others of the cell have no value\n";
  }
  if (limit) {
    text += "> " + brief(*limit) + ": the time limit stopped runs after " + brief(*limit) +
            " s; how long they would have taken is not known\n";
  } else if (bound) {
    text += "> " + brief(*bound) +
            ": the time limit stopped runs; of their values only this bound is known\n";
  }
  if (failed) {
    text += "failed: runs that failed never reach their goals, so they have no time\n";
  }
  return text;
}

std::string expectations(const Findings& findings) {
  if (findings.verdicts.empty()) {
    return "";
  }
  const bool any_open = std::any_of(findings.verdicts.begin(), findings.verdicts.end(),
                                    [](const Verdict& verdict) { return verdict.open(); });
  const std::size_t width = any_open ? 13 : 7;
  const std::string indent(width + 4, ' ');
  std::string text = "\nExpectations\n";
  for (const Verdict& verdict : findings.verdicts) {
    const std::string word = verdict.met() ? "met" : verdict.open() ? "not known yet" : "NOT MET";
    text += "  " + word + std::string(width + 2 - word.size(), ' ') +
            files::one_line(verdict.name) +
            (verdict.expected.empty() ? "" : ": " + files::one_line(verdict.expected)) + '\n';
    if (!verdict.trouble.empty()) {
      text += indent + files::one_line(verdict.trouble) + '\n';
    }
    for (const Claim& claim : verdict.claims) {
      if (!claim.holds) {
        text += indent + files::one_line(claim.sentence) + '\n';
      }
    }
  }
  return text;
}

std::string troubles(const Findings& findings, const std::string& database) {
  std::string text;
  std::size_t listed = 0;
  for (const Run& run : findings.results.runs) {
    if (!run.broken() || ++listed > kMostRuns) {
      continue;
    }
    text += "  " + files::one_line(name_of(findings.results, run)) + ": " +
            files::one_line(ending_in_words(run)) + "\n    " +
            files::one_line(replay_command(database, run.id)) + '\n';
  }
  if (listed > kMostRuns) {
    text += "  and " + counted(listed - kMostRuns, "more", "more") + '\n';
  }
  if (listed > 0) {
    text = "\nRuns that ended abnormally\n" + text;
  }
  if (!findings.disagreements.empty()) {
    text += "\nEqual seeds, different runs\n";
  }
  for (const Disagreement& disagreement : findings.disagreements) {
    text += "  " + files::one_line(in_words(findings.results, disagreement)) + '\n';
  }
  return text;
}

}  // namespace

std::string terminal_report(const Findings& findings, const std::string& database,
                            std::size_t width) {
  std::string text = files::one_line(findings.results.experiment);
  if (!findings.results.description.empty()) {
    text += ": " + files::one_line(findings.results.description);
  }
  text += '\n' + files::one_line(size_in_words(findings));
  if (findings.broken() > 0) {
    text += "; " + std::to_string(findings.broken()) + " ended abnormally";
  }
  if (findings.pending() > 0) {
    text += "; " + std::to_string(findings.pending()) + " still to be done";
  }
  text += '\n';
  if (const std::string effects = effects_in_words(findings); !effects.empty()) {
    text += files::one_line(effects) + '\n';
  }
  text += '\n' + tables(findings, width);
  if (!findings.measures.empty()) {
    text += "\nmean +- standard deviation over the runs of a cell that ended normally\n";
  }
  text += legend(findings);
  if (const std::string note = one_run_in_words(findings); !note.empty()) {
    text += '\n' + files::one_line(note) + '\n';
  }
  if (const std::string note = copies_in_words(findings); !note.empty()) {
    text += '\n' + files::one_line(note) + '\n';
  }
  if (const std::string note = give_ups_in_words(findings); !note.empty()) {
    text += '\n' + files::one_line(note) + '\n';
  }
  return text + expectations(findings) + troubles(findings, database);
}

}  // namespace elsie::report
