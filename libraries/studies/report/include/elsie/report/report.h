// The forms of a report. Each depends only on the findings, the page also on the trajectories and
// timelines, so that the same database gives the same bytes.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/report/answers.h"
#include "elsie/report/findings.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// For a terminal: cells and measures, expectations, failed runs. A table wider than `width`
/// characters is split by measures. `database` is the name that the user gave; commands to be
/// copied contain it.
std::string terminal_report(const Findings& findings, const std::string& database,
                            std::size_t width = 100);

/// A row for each run, including pending ones: run, cell, factors, seed, repetition, ending, all
/// measures. Commas and quotes as in RFC 4180, lines end with a line feed; numbers have enough
/// digits to give the same bits when read.
std::string csv_report(const Findings& findings);

/// JUnit's XML, as Jenkins and GitLab read it: a test suite for the experiment; a test case for
/// each expectation, one for failed runs, and one for equal seeds with different runs.
std::string junit_report(const Findings& findings, const std::string& database);

/// One JSON object; docs/reports.md lists its members.
std::string json_report(const Findings& findings, const Answers& answers = {});

/// One self-contained HTML page. `file` is the file of the findings; trajectories and timelines are
/// read from it cell by cell. At most a hundred cells have a section with figures, and at most a
/// dozen runs are played; `cells` selects cells whose labels contain it. Throws like ResultsFile.
std::string html_report(const Findings& findings, const ResultsFile& file,
                        const std::string& database, const std::string& cells = "",
                        const Answers& answers = {});

/// A row for each cell: its levels, how its runs ended, and of each measure the number of values,
/// mean, standard deviation, interval, quartiles, bounds. Form and numbers as in csv_report().
std::string cells_csv(const Findings& findings);

/// A table of cells and measures for LaTeX with the package booktabs, in a longtable from 40 cells
/// on. Texts of users are escaped.
std::string latex_report(const Findings& findings);

}  // namespace elsie::report
