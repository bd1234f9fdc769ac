// The sections of the page.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "elsie/report/findings.h"
#include "elsie/report/results.h"

#include "figures.h"

namespace elsie::report {

struct PageContext {
  const Findings& findings;
  const ResultsFile& file;
  const std::string& database;  // as the user calls it
  const Inks& inks;
  /// The cells that have a section of their own, ascending.
  const std::vector<std::size_t>& detailed;

  bool is_detailed(std::size_t cell) const;
};

/// Which cells have a section of their own: those whose label has `filter` in it; of too many for a
/// page first those with runs that are worth a look, the others evenly.
std::vector<std::size_t> cells_in_detail(const Findings& findings, const std::string& filter);

/// Texts that are compiled in: page.css, page.js.
extern const char* const kPageStyle;
extern const char* const kPageScript;

/// What the experiment is, whether what was expected has come true, what went wrong.
std::string answer_section(const PageContext& page);
/// Cells against each other: success, all measures as a table and as box plots.
std::string comparison_sections(const PageContext& page);
/// Each cell by itself. Reads the file.
std::string cell_sections(const PageContext& page);
/// How the numbers were made, and from what.
std::string methods_section(const PageContext& page);

/// "elsie replay ..." for copying.
std::string command(const PageContext& page, const Run& run);
/// "success", "time limit", "crash"..., marked when it is no success.
std::string ending_tag(const Findings& findings, const Run& run);
/// Where a cell's own section is on the page.
std::string anchor(std::size_t cell);

}  // namespace elsie::report
