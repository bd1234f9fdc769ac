// elsie explain: who decided when in a recorded run, in words, numbers and a picture.
#include <algorithm>
#include <exception>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/base/read_whole.h"
#include "elsie/files/outputs.h"
#include "elsie/mcap/reader.h"
#include "elsie/picture/timeline.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/traces/trace_account.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "explain_report.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace {

using traces::TimeSpan;
using traces::Trace;

struct ExplainOptions {
  std::string recording;
  std::vector<std::string> robots;
  std::optional<double> from;
  std::optional<double> to;
  std::size_t episodes = 20;
  bool all = false;
  std::optional<std::string> picture;
  int width = 1600;
  bool json = false;
};

constexpr const char* kExplainExamples = R"(
Examples:
  elsie run worlds/clutter.xml --record clutter.mcap
  elsie explain clutter.mcap
  elsie explain clutter.mcap --picture timeline.png
  elsie explain clutter.mcap --robot r1 --from 30 --to 45 --all
)";

Trace read_recorded(const std::string& file) {
  if (base::why_unreadable(file).empty() && !mcap::may_be_mcap(file)) {
    throw BadInput("'" + file +
                   "' is not a recording with decisions; expected a file that `elsie run WORLD "
                   "--record FILE.mcap` has written");
  }
  try {
    return recording::read_trace(file);
  } catch (const mcap::McapError& error) {
    throw BadInput(error.what());
  }
}

/// The indices of the requested robots. A robot whose behaviours were edited has several.
std::vector<std::size_t> chosen(const Trace& trace, const std::vector<std::string>& ids) {
  std::vector<std::size_t> places;
  std::vector<std::string> known;
  for (const auto& robot : trace.robots) {
    known.push_back(robot.id);
  }
  for (const std::string& id : ids) {
    if (trace.without_decisions.contains(id)) {
      throw BadInput("--robot: of '" + id +
                     "' only the poses were recorded; expected a recording " +
                     "made with --record-robots " + id);
    }
    if (std::find(known.begin(), known.end(), id) == known.end()) {
      throw BadInput("--robot: the recording has no robot '" + id + "'" +
                     base::did_you_mean(id, known));
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i] == id) {
        places.push_back(i);
      }
    }
  }
  for (std::size_t i = 0; ids.empty() && i < known.size(); ++i) {
    places.push_back(i);
  }
  return places;
}

TimeSpan span_of(const Trace& trace, const ExplainOptions& options) {
  const TimeSpan asked{options.from.value_or(0.0),
                       options.to.value_or(std::numeric_limits<double>::infinity())};
  if (!(asked.from_s < asked.to_s)) {
    throw BadInput("--from must be less than --to");
  }
  if (options.from && asked.from_s >= trace.end_s) {
    throw BadInput("--from: the recording ends at " + base::number_text(trace.end_s, 6) + " s");
  }
  return traces::within(asked, trace);
}

int explain(const ExplainOptions& options) {
  if (options.picture) {
    files::require_apart({{"--picture", *options.picture}}, {options.recording});
    require_picture(*options.picture, "--picture");
  }
  const Trace trace = read_recorded(options.recording);
  const std::vector<std::size_t> places = chosen(trace, options.robots);
  const TimeSpan span = span_of(trace, options);
  std::vector<ExplainedRobot> robots;
  for (const std::size_t place : places) {
    robots.push_back({&trace.robots[place], traces::account(trace.robots[place], span)});
  }
  std::exception_ptr failure;  // of the picture; reported after the text
  if (options.picture) {
    const picture::Timeline timeline{
        trace, places, span, "", {"seed " + std::to_string(trace.seed) + ", " + ending(trace)}};
    try {
      picture::save_timeline(timeline, *options.picture, {options.width, 0});
    } catch (const std::invalid_argument& error) {
      throw BadInput(std::string("--picture: ") + error.what() + " See --robot and --width.");
    } catch (...) {
      failure = std::current_exception();
    }
  }
  if (options.json) {
    data_out() << json(trace, span, robots);
  } else {
    out() << headlines(trace);
    for (const ExplainedRobot& robot : robots) {
      const std::size_t most =
          options.all ? std::numeric_limits<std::size_t>::max() : options.episodes;
      out() << '\n' << report(trace, robot, most);
    }
  }
  if (failure) {
    out().flush();
    std::rethrow_exception(failure);
  }
  return kSuccess;
}

}  // namespace

void add_explain_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("explain", "Show who decided when in a run, from its recording");
  command->footer(kExplainExamples);
  auto options = std::make_shared<ExplainOptions>();
  command
      ->add_option("RECORDING", options->recording,
                   "Recording, written by `elsie run --record FILE.mcap`")
      ->required();
  command->add_option("--robot", options->robots, "Show this robot only; may be repeated")
      ->type_name("ID")
      ->allow_extra_args(false);
  command->add_option("--from", options->from, "Begin at this simulated time, s")
      ->check(non_negative_number());
  command->add_option("--to", options->to, "End at this simulated time, s")
      ->check(positive_number());
  command
      ->add_option("--episodes", options->episodes,
                   "At most so many episodes for each coordinator; short ones are joined")
      ->check(whole_number(1, 1000000))
      ->capture_default_str();
  command->add_flag("--all", options->all, "Show all episodes, without joining short ones");
  command
      ->add_option("--picture", options->picture, "Draw who decided, shares and weights over time")
      ->type_name("FILE.png|FILE.svg");
  command->add_option("--width", options->width, "Width of the picture in pixels")
      ->check(whole_number(200, 8000))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command->callback([&job, options] { job = [options] { return explain(*options); }; });
}

}  // namespace elsie::program
