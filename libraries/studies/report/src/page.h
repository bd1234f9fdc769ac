// The sections of the page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/report/answers.h"
#include "elsie/report/findings.h"
#include "elsie/report/results.h"

#include "charts.h"
#include "figures.h"

namespace elsie::report {

struct PageContext {
  const Findings& findings;
  const ResultsFile& file;
  const std::string& database;  // as the user named it
  const Inks& inks;
  /// The cells that have a section, ascending.
  const std::vector<std::size_t>& detailed;
  const Answers& answers;

  bool is_detailed(std::size_t cell) const;
};

/// With more cells than these, figures with something for each cell are left out.
inline constexpr std::size_t kMostRows = 200;

/// A table of texts, the first row as its head; columns of numbers are aligned right.
std::string html_table(const std::vector<std::vector<std::string>>& rows, std::size_t text_columns);

/// A chart of the page. `head`: HTML above it.
std::string chart_figure(const Chart& chart, const picture::Size& size,
                         const std::string& head = "");

/// The cells that get a section: those whose label contains `filter`. If there are too many: first
/// those with notable runs, then an even selection of the others.
std::vector<std::size_t> cells_in_detail(const Findings& findings, const std::string& filter);

/// A page with runs is no larger. Without them it may be, if an experiment's texts are.
inline constexpr std::size_t kMostPageBytes = 10'000'000;

/// Files that are compiled in: page.css, page.js.
extern const char* const kPageStyle;
extern const char* const kPageScript;

/// The experiment, whether its expectations are met, and its failures.
std::string answer_section(const PageContext& page);
/// The comparison of cells: success rates, all measures as a table and as box plots.
std::string comparison_sections(const PageContext& page);
/// What was asked for, and the results by factor; "" if nothing is varied.
std::string factor_sections(const PageContext& page);
/// Times until the goals where some are cut off, and what happened over time. Reads the file.
std::string time_sections(const PageContext& page);
/// Runs that the page plays, in at most so many bytes, and why others are not among them; "" if
/// there are none. Reads the file.
std::string watch_section(const PageContext& page, std::size_t most_bytes);
/// A section for each cell. Reads the file.
std::string cell_sections(const PageContext& page);
/// The methods and sources of the numbers.
std::string methods_section(const PageContext& page);

/// A table of runs from rows of run_row(); `what` and `why`: the heads of these columns.
std::string runs_table(const std::string& what, const std::string& why, const std::string& rows);
/// A run, what it is about, why it is there, and the command that replays it. `what` and `why` are
/// HTML.
std::string run_row(const PageContext& page, const Run& run, const std::string& what,
                    const std::string& why);
/// "success", "time limit", "crash"..., marked unless it is a success.
std::string ending_tag(const Findings& findings, const Run& run);
/// The anchor of a cell's section.
std::string anchor(std::size_t cell);

}  // namespace elsie::report
