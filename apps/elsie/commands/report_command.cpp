// elsie report: reports the results of an experiment.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "elsie/base/write_whole.h"
#include "elsie/experiment/reader.h"
#include "elsie/report/formulas.h"
#include "elsie/report/report.h"

#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "status_line.h"
#include "supervised.h"

namespace elsie::program {

namespace fs = std::filesystem;
using report::Findings;
using report::ResultsFile;

namespace {

struct ReportOptions {
  std::string database;
  std::optional<std::string> csv;
  std::optional<std::string> junit;
  std::optional<std::string> html;
  std::string cells;
  bool json = false;
  bool quiet = false;
};

constexpr const char* kReportExamples = R"(
Examples:
  elsie report beams.sqlite
  elsie report beams.sqlite --html beams.html
  elsie report beams.sqlite --csv runs.csv --junit results.xml --quiet

Exit codes: 0 everything is as expected; 1 an expectation is not met, a run ended abnormally or
is still to be done, or equal seeds gave different runs; 2 bad input; 4 anything else: a full disk.
)";

/// Checks that the file's folder takes new files, by creating the file before any work is done.
/// Permissions alone do not show that, for example on a read-only medium.
void require_room(const std::string& file, const char* option) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(file, ignored))) {
    return;
  }
  const int made = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (made < 0) {
    throw BadInput(std::string(option) + ": cannot write '" + file +
                   "': " + std::generic_category().message(errno) +
                   "; name a file in a folder that takes new files");
  }
  close(made);
  unlink(file.c_str());
}

void require_output(const std::optional<std::string>& file, const char* option, const char* suffix,
                    const std::string& database) {
  if (!file) {
    return;
  }
  std::error_code error;
  const bool device = fs::is_character_file(*file, error) || fs::is_fifo(*file, error);
  if (!device && fs::path(*file).extension() != suffix) {
    throw BadInput(std::string(option) + ": expected a name that ends in " + suffix + ", but '" +
                   *file + "' does not");
  }
  if (fs::equivalent(*file, database, error)) {
    throw BadInput(std::string(option) + ": '" + *file +
                   "' is the database itself; choose another name");
  }
  require_replaceable(*file, option, "report");
  require_room(*file, option);
}

void write(const std::string& file, const std::string& text, const char* option) {
  if (const int error = base::write_whole(file, text); error != 0) {
    throw base::Error(std::string(option) + ": '" + file +
                      "' could not be written: " + std::generic_category().message(error));
  }
}

/// The width of the terminal in characters; tables for a file are not wrapped.
std::size_t width() { return terminal_columns(out_descriptor(), 120); }

Findings found(const ResultsFile& file) {
  report::Results results = file.results();
  const auto experiment = experiment::parse_outline(results.text, results.file);
  for (const std::string& sentence : report::add_formulas(results, experiment.measures)) {
    std::cerr << "elsie: " << sentence << '\n';
  }
  report::Questions questions;
  questions.measures = experiment::shown_measures(experiment.measures);
  questions.expectations = experiment.expectations;
  return report::find(std::move(results), questions);
}

void require_cells(const Findings& findings, const std::string& part) {
  const auto& cells = findings.results.cells;
  if (!cells.empty() && std::none_of(cells.begin(), cells.end(), [&](const auto& cell) {
        return cell.label.find(part) != std::string::npos;
      })) {
    throw BadInput("--cells: no cell's name contains '" + part +
                   "'; expected a part of a name, as of '" + cells.front().label + "'");
  }
}

int report(const ReportOptions& options) {
  require_output(options.csv, "--csv", ".csv", options.database);
  require_output(options.junit, "--junit", ".xml", options.database);
  require_output(options.html, "--html", ".html", options.database);
  const ResultsFile file(options.database);
  const Findings findings = found(file);
  require_cells(findings, options.cells);
  if (options.csv) {
    write(*options.csv, report::csv_report(findings), "--csv");
  }
  if (options.junit) {
    write(*options.junit, report::junit_report(findings, options.database), "--junit");
  }
  if (options.html) {
    write(*options.html, report::html_report(findings, file, options.database, options.cells),
          "--html");
  }
  if (options.json) {
    out() << report::json_report(findings);
  } else if (!options.quiet) {
    out() << report::terminal_report(findings, options.database, width());
  }
  return findings.good() ? kSuccess : kGoalMissed;
}

}  // namespace

void add_report_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "report", "Report the results of an experiment: tables, a page, tests for CI");
  command->footer(kReportExamples);
  auto options = std::make_shared<ReportOptions>();
  command->add_option("DATABASE", options->database, "Results, written by `elsie batch`")
      ->required();
  CLI::Option* html =
      command->add_option("--html", options->html, "Write a page with figures; needs no network")
          ->type_name("FILE.html");
  command
      ->add_option("--cells", options->cells,
                   "With --html: draw the cells whose names have this text in them; default: all, "
                   "or a hundred of more")
      ->type_name("TEXT")
      ->needs(html);
  command->add_option("--csv", options->csv, "Write a table with a row for each run")
      ->type_name("FILE.csv");
  command->add_option("--junit", options->junit, "Write the expectations as test cases, for CI")
      ->type_name("FILE.xml");
  CLI::Option* json =
      command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing")->excludes(json);
  command->callback([&job, options] { job = [options] { return report(*options); }; });
}

}  // namespace elsie::program
