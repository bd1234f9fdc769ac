#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "elsie/base/number_text.h"
#include "elsie/files/clean_text.h"
#include "elsie/files/outputs.h"
#include "elsie/mcap/records.h"
#include "elsie/process/text_table.h"
#include "elsie/recording/recorded_run.h"

#include "command.h"
#include "environment.h"
#include "graph_file.h"
#include "output_files.h"
#include "replay.h"
#include "run_report.h"
#include "start_world.h"
#include "streams.h"

namespace elsie::program {

namespace {

using files::one_line;
using recording::RecordedRun;

RecordedRun read(const ReplayOptions& options) {
  try {
    return options.at ? recording::read_recorded_run(options.file, *options.at)
                      : recording::read_recorded_run(options.file);
  } catch (const mcap::McapError& error) {
    throw BadInput(error.what());
  }
}

std::string ending(const RecordedRun& run) {
  if (!run.result) {
    return "no outcome: the recording ends after " + base::fixed_text(run.end_s, 1) + " s";
  }
  const auto& result = *run.result;
  return result.reason.empty()
             ? result.outcome + " after " + base::fixed_text(result.simulated_s, 1) + " s"
             : headline(result.outcome, result.simulated_s, result.reason);
}

std::string seed_of(const RecordedRun& run) { return "seed " + std::to_string(run.seed); }

/// The contents of the recording in words.
std::string report(const RecordedRun& run) {
  std::string out;
  if (run.of_elsie) {
    out += one_line("world '" + run.world + "' (" + run.world_file + "), " + seed_of(run) +
                    ", recorded by " + run.library) +
           '\n' + one_line(ending(run)) + '\n';
    if (run.result && !run.result->state_hash.empty()) {
      out += "state hash " + one_line(run.result->state_hash) + " after " +
             std::to_string(run.result->steps) + " steps\n";
    }
    if (run.result && !run.result->measures.empty()) {
      out += "measures:";
      for (const auto& [name, value] : run.result->measures) {
        out += ' ' + one_line(name) + ' ' + base::number_text(value, 6);
      }
      out += '\n';
    }
    out += "a sample every " + base::number_text(run.period_s, 6) + " s\n";
    if (!run.crowd.empty()) {
      out += "of " + std::to_string(run.crowd.size()) + " robots only the poses\n";
    }
  } else if (run.library.starts_with("elsie ")) {
    out += "the recording breaks off before its first second was written\n";
  } else {
    out += "no run of Elsie: recorded by '" + one_line(run.library) + "'\n";
  }
  out += run.missing_end.empty() ? "complete\n" : run.missing_end + '\n';
  std::vector<std::vector<std::string>> rows{{"channel", "schema", "messages"}};
  for (const auto& channel : run.channels) {
    rows.push_back({channel.topic, channel.schema, std::to_string(channel.messages)});
  }
  constexpr std::size_t kTextColumns = 2;
  return out + '\n' + process::laid_out(rows, kTextColumns);
}

/// What a picture says below or beside its title.
std::string line_of(const RecordedRun& run, const ReplayOptions& options) {
  return (options.at ? "at " + base::number_text(run.shown_s, 6) + " s" : ending(run)) + "  (" +
         seed_of(run) + ")";
}

void require_time(const RecordedRun& run, const ReplayOptions& options) {
  constexpr double kHair = 1e-9;  // s
  if (options.at && *options.at > run.end_s + kHair) {
    throw BadInput("--at: the recording ends at " + base::number_text(run.end_s, 6) + " s");
  }
}

void draw_graph(const RecordedRun& run, const ReplayOptions& options, const GraphFile& to) {
  require_time(run, options);
  for (const picture::RobotTrack& robot : run.robots) {
    const auto shown = run.graphs.find(robot.id);
    if (!to.robot().empty() && robot.id != to.robot()) continue;
    if (shown != run.graphs.end() && !shown->second.graphs.empty()) {
      return to.save(shown->second.graphs, shown->second.lights, robot.id, line_of(run, options));
    }
  }
  throw BadInput("--graph: the recording has no graph of " +
                 (to.robot().empty() ? "a robot" : "the robot '" + to.robot() + "'") +
                 kWhoHasGraphs);
}

void draw(const RecordedRun& run, const ReplayOptions& options) {
  if (run.world_xml.empty() && run.messages == 0 && !run.missing_end.empty()) {
    throw BadInput("--picture: '" + options.file +
                   "' breaks off before its first second was written, with the world and the "
                   "robots' places: there is nothing to draw");
  }
  if (!run.of_elsie || run.world_xml.empty()) {
    throw BadInput("--picture: there is no world in '" + options.file +
                   "'; expected a recording that `elsie run --record FILE.mcap` made");
  }
  require_time(run, options);
  const bool has_drives = run.world_xml.find("<drive>") != std::string::npos;
  const plugin::Host drives = has_drives ? load_plugins(options.plugins) : plugin::Host();
  recording::save_picture(run, drives, {line_of(run, options)}, *options.views.picture,
                          {options.views.picture_width, 0});
}

/// The contents of the recording, and the command that repeats the run if its world was written.
std::string json(const RecordedRun& run, const std::optional<StartWorld>& written) {
  using Json = nlohmann::ordered_json;
  Json object = {{"recorded_by", run.library}, {"complete", run.missing_end.empty()}};
  if (run.of_elsie) {
    object["world"] = run.world;
    object["world_file"] = run.world_file;
    object["seed"] = run.seed;
    object["end_s"] = run.end_s;
    object["period_s"] = run.period_s;
    object["outcome"] = run.result ? Json(run.result->outcome) : Json();
    if (run.result) {
      object["reason"] = run.result->reason;
      object["simulated_s"] = run.result->simulated_s;
      object["steps"] = run.result->steps;
      object["state_hash"] = run.result->state_hash;
      object["measures"] = Json::object();
      for (const auto& [name, value] : run.result->measures) object["measures"][name] = value;
    }
  }
  object["channels"] = Json::array();
  for (const auto& channel : run.channels) {
    object["channels"].push_back(
        {{"topic", channel.topic}, {"schema", channel.schema}, {"messages", channel.messages}});
  }
  if (written) {
    object["command"] = written->command;
    object["duration_s"] = written->duration_s ? Json(*written->duration_s) : Json();
  }
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

StartWorld write_world(const RecordedRun& run, const ReplayOptions& options) {
  if (run.start_xml.empty()) {
    throw BadInput("--world: there is no world in the recording");
  }
  return write_start_world({run.start_xml, run.world_file, run.seed, run.time_limit_s},
                           load_plugins(options.plugins), read_options(), options.plugins,
                           *options.world);
}

}  // namespace

int replay_recording(const ReplayOptions& options) {
  if (options.at && !options.views.picture && !options.views.graph) {
    throw BadInput("--at: there is nothing to draw; expected --picture or --graph, too");
  }
  std::vector<files::Output> outputs;
  if (options.views.picture) outputs.push_back({"--picture", *options.views.picture});
  std::optional<GraphFile> graph;
  if (options.views.graph) {
    graph.emplace(*options.views.graph);
    outputs.push_back({"--graph", graph->file()});
  }
  files::require_apart(outputs, {options.file});
  if (options.views.picture) require_picture(*options.views.picture, "--picture");
  if (options.world) {
    require_new_world(*options.world);
  }
  const RecordedRun run = read(options);
  if (options.views.picture) {
    draw(run, options);
  }
  if (graph) draw_graph(run, options, *graph);
  std::optional<StartWorld> written;
  if (options.world) written = write_world(run, options);
  if (options.json) {
    data_out() << json(run, written);
  } else {
    out() << (written ? written->in_words() : "") << report(run);
  }
  return kSuccess;
}

}  // namespace elsie::program
