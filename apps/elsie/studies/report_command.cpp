// elsie report: reports the results of an experiment.
#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <unistd.h>

#include "elsie/experiment/reader.h"
#include "elsie/files/outputs.h"
#include "elsie/files/scratch_folder.h"
#include "elsie/files/write_whole.h"
#include "elsie/report/figure_files.h"
#include "elsie/report/formulas.h"
#include "elsie/report/report.h"

#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "status_line.h"
#include "streams.h"

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
  std::optional<std::string> cells_csv;
  std::optional<std::string> latex;
  std::optional<std::string> figures;
  std::vector<std::string> formats = {"svg"};
  std::vector<std::string> compared;  // groups, two by two
  report::Asked asked;
  std::string cells;
  bool json = false;
  bool quiet = false;
};

constexpr const char* kReportExamples = R"(
Examples:
  elsie report beams.sqlite
  elsie report beams.sqlite --html beams.html
  elsie report beams.sqlite --csv runs.csv --junit results.xml --quiet
  elsie report beams.sqlite --by coordinator --model 'path_length_m ~ coordinator * beams'
  elsie report beams.sqlite --compare coordinator=fusion coordinator=arbitration
  elsie report beams.sqlite --figures figures --format svg,pdf --latex table.tex

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

void require_output(const std::optional<std::string>& file, const char* option,
                    const char* suffix) {
  if (!file) {
    return;
  }
  std::error_code error;
  const bool device = fs::is_character_file(*file, error) || fs::is_fifo(*file, error);
  if (!device && fs::path(*file).extension() != suffix) {
    throw BadInput(std::string(option) + ": expected a name that ends in " + suffix + ", but '" +
                   *file + "' does not");
  }
  require_replaceable(*file, option, "report");
  require_room(*file, option);
}

void require_outputs(const ReportOptions& options) {
  struct Asked {
    const char* option;
    const std::optional<std::string>& file;
    const char* suffix;
  };
  const Asked all[] = {{"--csv", options.csv, ".csv"},
                       {"--junit", options.junit, ".xml"},
                       {"--html", options.html, ".html"},
                       {"--cells-csv", options.cells_csv, ".csv"},
                       {"--latex", options.latex, ".tex"}};
  std::vector<files::Output> outputs;
  for (const Asked& each : all) {
    if (each.file) {
      outputs.push_back({each.option, *each.file});
    }
  }
  files::require_apart(outputs, {options.database});
  for (const Asked& each : all) {
    require_output(each.file, each.option, each.suffix);
  }
}

void write(const std::string& file, const std::string& text, const char* option) {
  if (const int error = files::write_whole(file, text); error != 0) {
    throw base::Error(std::string(option) + ": '" + file +
                      "' could not be written: " + std::generic_category().message(error));
  }
}

/// The width of the terminal in characters; tables for a file are not wrapped.
std::size_t width() { return terminal_columns(out_descriptor(), 120); }

// `sentences`: on formulas without values in some runs.
Findings found(const ResultsFile& file, std::vector<std::string>& sentences) {
  report::Results results = file.results();
  const auto experiment = experiment::parse_outline(results.text, results.file);
  sentences = report::add_formulas(results, experiment.measures);
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

// Checks, before anything is drawn, that figures can be written into the folder, or that it can be
// made.
void require_folder(const std::string& folder) {
  std::error_code error;
  const std::string what = "--figures: cannot write figures into '" + folder + "': ";
  const bool is_new = !fs::exists(fs::symlink_status(folder, error));
  if (!is_new && !fs::is_directory(folder, error)) {
    throw BadInput(what + "it is no folder; choose another name");
  }
  const fs::path place = is_new ? fs::path(folder) / ".." : fs::path(folder);
  try {
    const files::ScratchFolder probe(fs::absolute(place).lexically_normal());
  } catch (const fs::filesystem_error& problem) {
    throw BadInput(what + problem.code().message() +
                   (is_new ? "; name a folder in one that exists and takes new files"
                           : "; name a folder that takes new files"));
  }
}

void draw(const Findings& findings, const ResultsFile& file, const report::Answers& answers,
          const ReportOptions& options) {
  try {
    report::write_figures(findings, file, answers, *options.figures, options.formats,
                          options.cells);
  } catch (const report::FigureInTheWay& error) {
    throw BadInput(std::string("--figures: ") + error.what());
  }
}

report::Answers answers_to(const Findings& findings, const ReportOptions& options) {
  report::Asked asked = options.asked;
  for (std::size_t i = 0; i + 1 < options.compared.size(); i += 2) {
    asked.compared.emplace_back(options.compared[i], options.compared[i + 1]);
  }
  try {
    return report::answer(findings, asked);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  }
}

int report(const ReportOptions& options) {
  require_outputs(options);
  const ResultsFile file(options.database);
  std::vector<std::string> sentences;
  const Findings findings = found(file, sentences);
  require_cells(findings, options.cells);
  const report::Answers answers = answers_to(findings, options);
  if (options.figures) {
    require_folder(*options.figures);
  }
  for (const std::string& sentence : sentences) {
    err() << "elsie: " << sentence << '\n';
  }
  // Before all else, because the names of the figures, which may be taken, follow from the results.
  if (options.figures) {
    draw(findings, file, answers, options);
  }
  if (options.csv) {
    write(*options.csv, report::csv_report(findings), "--csv");
  }
  if (options.junit) {
    write(*options.junit, report::junit_report(findings, options.database), "--junit");
  }
  if (options.html) {
    write(*options.html,
          report::html_report(findings, file, options.database, options.cells, answers), "--html");
  }
  if (options.cells_csv) {
    write(*options.cells_csv, report::cells_csv(findings), "--cells-csv");
  }
  if (options.latex) {
    write(*options.latex, report::latex_report(findings), "--latex");
  }
  if (options.json) {
    data_out() << report::json_report(findings, answers);
  } else if (!options.quiet) {
    out() << (answers.none() ? report::terminal_report(findings, options.database, width())
                             : report::terminal_answers(findings, answers));
  }
  return findings.good() ? kSuccess : findings.open() ? kOtherFailure : kGoalMissed;
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
  CLI::Option* figures =
      command
          ->add_option("--figures", options->figures,
                       "Write every figure of the page as a file of its own into this folder")
          ->type_name("FOLDER");
  command->add_option("--format", options->formats, "With --figures: their formats; default: svg")
      ->delimiter(',')
      ->check(CLI::IsMember(report::kFigureFormats))
      ->needs(figures);
  command
      ->add_option("--by", options->asked.by,
                   "Print the results by the levels of these factors, over all others")
      ->delimiter(',')
      ->type_name("FACTOR");
  command
      ->add_option("--compare", options->compared,
                   "Compare two groups of cells, as in 'coordinator=fusion; speed=0.1', with "
                   "effects and tests")
      ->type_size(2)
      ->type_name("GROUP");
  command
      ->add_option("--model", options->asked.models,
                   "Fit a model, as in 'time_s ~ speed + coordinator'; a:b is an interaction, a*b "
                   "all of both")
      ->allow_extra_args(false)
      ->type_name("FORMULA");
  command
      ->add_option("--cells", options->cells,
                   "With --html: draw the cells whose names have this text in them; default: all, "
                   "or a hundred of more")
      ->type_name("TEXT")
      ->needs(html);
  command->add_option("--csv", options->csv, "Write a table with a row for each run")
      ->type_name("FILE.csv");
  command->add_option("--cells-csv", options->cells_csv, "Write a table with a row for each cell")
      ->type_name("FILE.csv");
  command->add_option("--latex", options->latex, "Write a table for LaTeX with booktabs")
      ->type_name("FILE.tex");
  command->add_option("--junit", options->junit, "Write the expectations as test cases, for CI")
      ->type_name("FILE.xml");
  CLI::Option* json =
      command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command->add_flag("--quiet", options->quiet, "Print nothing")->excludes(json);
  command->callback([&job, options] { job = [options] { return report(*options); }; });
}

}  // namespace elsie::program
