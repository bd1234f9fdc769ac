// The forms of a report. Each is a function of the findings, and of the drawings where there are
// some: the same database gives the same bytes.
#pragma once

#include <cstddef>
#include <string>

#include "elsie/report/findings.h"
#include "elsie/report/results.h"

namespace elsie::report {

/// For a terminal: cells and measures, expectations, runs that did not end by themselves. A table
/// that is wider than `width` characters is told in several, a part of the measures each.
/// `database` is how the user calls it, for commands to be copied.
std::string terminal_report(const Findings& findings, const std::string& database,
                            std::size_t width = 100);

/// A row for each run, pending ones too: run, cell, the factors, seed, repetition, how it ended,
/// all measures. Commas, quotes as in RFC 4180, lines that end with a line feed; numbers have as
/// many digits as give the same bits when read.
std::string csv_report(const Findings& findings);

/// JUnit's XML, as Jenkins and GitLab read it: a test suite for the experiment; a test case for
/// each expectation, one that all runs ended by themselves, and one that equal seeds gave equal
/// runs.
std::string junit_report(const Findings& findings, const std::string& database);

/// One JSON object: docs/reports.md has its members.
std::string json_report(const Findings& findings);

/// One page of HTML with everything in it. `file` is where the findings are from: what is drawn is
/// read from it cell by cell. Of a hundred cells at most there is a section with what is drawn;
/// `cells` is a part of the labels of those that are asked for. Throws as ResultsFile does.
std::string html_report(const Findings& findings, const ResultsFile& file,
                        const std::string& database, const std::string& cells = "");

}  // namespace elsie::report
