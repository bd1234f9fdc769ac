// A table for LaTeX.
#include <vector>

#include "elsie/files/clean_text.h"
#include "elsie/report/factors.h"
#include "elsie/report/report.h"

#include "numbers.h"
#include "words.h"

namespace elsie::report {

namespace {

// A table that is longer goes over several pages.
constexpr std::size_t kLongTable = 40;

std::string latex(const std::string& text) {
  std::string escaped;
  for (const char c : files::one_line(text)) {
    switch (c) {
      case '\\':
        escaped += "\\textbackslash{}";
        break;
      case '~':
        escaped += "\\textasciitilde{}";
        break;
      case '^':
        escaped += "\\textasciicircum{}";
        break;
      case '<':
        escaped += "\\textless{}";
        break;
      case '>':
        escaped += "\\textgreater{}";
        break;
      case '[':  // at the beginning of a row, an argument of the command before it
      case '*':
        escaped += std::string("{") + c + "}";
        break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}':
        escaped += '\\';
        [[fallthrough]];
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string value(const MeasureFindings& found, std::optional<int> decimals) {
  if (found.censoring) {
    std::string words = censored_in_words(found, decimals);
    for (std::size_t at = words.find('>'); at != std::string::npos; at = words.find('>', at + 3)) {
      words.replace(at, 1, "$>$");
    }
    return words;
  }
  if (!found.all) {
    return "--";
  }
  const MeanText text = mean_text(*found.all, found.interval, decimals);
  // An exponent is no number of LaTeX's mathematics.
  const auto plain = [](const std::string& number) {
    const std::size_t e = number.find('e');
    return e == std::string::npos ? number
                                  : number.substr(0, e) + " \\cdot 10^{" +
                                        std::to_string(std::stoi(number.substr(e + 1))) + "}";
  };
  return "$" + plain(text.mean) + (text.deviation.empty() ? "" : " \\pm " + plain(text.deviation)) +
         "$";
}

}  // namespace

std::string latex_report(const Findings& findings) {
  const Results& results = findings.results;
  const std::vector<VariedFactor> factors = varied_factors(results);
  const bool is_long = findings.cells.size() >= kLongTable;
  std::string columns(std::max<std::size_t>(factors.size(), 1), 'l');
  std::string heads;
  for (const VariedFactor& factor : factors) {
    heads += (heads.empty() ? "" : " & ") + latex(factor.name);
  }
  heads = factors.empty() ? "cell" : heads;
  heads += " & success";
  columns += 'r';
  std::vector<std::optional<int>> decimals;
  for (std::size_t i = 0; i < findings.measures.size(); ++i) {
    const Measure& measure = results.measures[findings.measures[i]];
    heads += " & " + latex(in_words(measure.name, measure.unit)) +
             (measure.unit.empty() ? "" : " (" + latex(measure.unit) + ")");
    columns += 'r';
    decimals.push_back(decimals_of(findings, i));
  }
  const std::string caption =
      "\\caption{" + latex(results.experiment) +
      ": mean $\\pm$ standard deviation over the runs of a cell that ended normally" +
      "; $>$: stopped by the time limit; failed: never reached its goals.}";
  const std::string table = is_long ? "longtable" : "tabular";
  std::string text = "% " + files::one_line(size_in_words(findings)) +
                     "; needs \\usepackage{booktabs}" +
                     (is_long ? " and \\usepackage{longtable}" : "") + "\n";
  text += is_long ? "" : "\\begin{table}\n\\centering\n" + caption + "\n";
  text += "\\begin{" + table + "}{" + columns + "}\n" + (is_long ? caption + " \\\\\n" : "") +
          "\\toprule\n" + heads + " \\\\\n\\midrule\n" + (is_long ? "\\endhead\n" : "");
  for (std::size_t i = 0; i < findings.cells.size(); ++i) {
    const CellFindings& cell = findings.cells[i];
    std::string row;
    for (const VariedFactor& factor : factors) {
      row += (row.empty() ? "" : " & ") + latex(factor.levels[factor.of_cell[i]]);
    }
    row = factors.empty() ? latex(results.cells[i].label) : row;
    row += " & " + success_in_words(cell);
    for (std::size_t j = 0; j < cell.measures.size(); ++j) {
      row += " & " + value(cell.measures[j], decimals[j]);
    }
    text += row + " \\\\\n";
  }
  text += "\\bottomrule\n\\end{" + table + "}\n";
  return text + (is_long ? "" : "\\end{table}\n");
}

}  // namespace elsie::report
