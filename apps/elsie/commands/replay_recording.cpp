#include "replay_recording.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#include "elsie/base/number_text.h"
#include "elsie/mcap/records.h"
#include "elsie/process/text_table.h"
#include "elsie/recording/recorded_run.h"
#include "elsie/world/document.h"
#include "elsie/world/error.h"
#include "elsie/world/markup.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "run_report.h"
#include "supervised.h"

namespace elsie::program {

namespace {

using recording::RecordedRun;

RecordedRun read(const RecordingOptions& options) {
  try {
    return options.at ? recording::read_recorded_run(options.recording, *options.at)
                      : recording::read_recorded_run(options.recording);
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
    out += "world '" + run.world + "' (" + run.world_file + "), " + seed_of(run) +
           ", recorded by " + run.library + '\n' + ending(run) + '\n';
    if (run.result && !run.result->state_hash.empty()) {
      out += "state hash " + run.result->state_hash + " after " +
             std::to_string(run.result->steps) + " steps\n";
    }
    if (run.result && !run.result->measures.empty()) {
      out += "measures:";
      for (const auto& [name, value] : run.result->measures) {
        out += ' ' + name + ' ' + base::number_text(value, 6);
      }
      out += '\n';
    }
    out += "a sample every " + base::number_text(run.period_s, 6) + " s\n";
  } else if (run.library.starts_with("elsie ")) {
    out += "the recording breaks off before its first second was written\n";
  } else {
    out += "no run of Elsie: recorded by '" + run.library + "'\n";
  }
  out += run.missing_end.empty() ? "complete\n" : run.missing_end + '\n';
  std::vector<std::vector<std::string>> rows{{"channel", "schema", "messages"}};
  for (const auto& channel : run.channels) {
    rows.push_back({channel.topic, channel.schema, std::to_string(channel.messages)});
  }
  constexpr std::size_t kTextColumns = 2;
  return out + '\n' + process::laid_out(rows, kTextColumns);
}

void draw(const RecordedRun& run, const RecordingOptions& options) {
  if (run.world_xml.empty() && run.messages == 0 && !run.missing_end.empty()) {
    throw BadInput("--picture: '" + options.recording +
                   "' breaks off before its first second was written, with the world and the "
                   "robots' places: there is nothing to draw");
  }
  if (!run.of_elsie || run.world_xml.empty()) {
    throw BadInput("--picture: there is no world in '" + options.recording +
                   "'; expected a recording that `elsie run --record FILE.mcap` made");
  }
  constexpr double kHair = 1e-9;  // s
  if (options.at && *options.at > run.end_s + kHair) {
    throw BadInput("--at: the recording ends at " + base::number_text(run.end_s, 6) + " s");
  }
  const std::string line =
      (options.at ? "at " + base::number_text(run.shown_s, 6) + " s" : ending(run)) + "  (" +
      seed_of(run) + ")";
  const bool has_drives = run.world_xml.find("<drive>") != std::string::npos;
  const plugin::Host drives = has_drives ? load_plugins({}) : plugin::Host();
  recording::save_picture(run, drives, {line}, *options.picture, {options.width, 0});
}

/// The world at the start of the run, whose files are found from another folder, too. Where they
/// are no longer what the world needs, it is as it was recorded, and whoever reads it says what is
/// missing.
std::string start_from(const RecordedRun& run, const std::filesystem::path& folder) {
  try {
    const plugin::Host host = load_plugins({});
    return world::Document(run.start_xml, run.world_file, host, read_options())
        .text_for(folder.string());
  } catch (const world::WorldError&) {
    return run.start_xml;
  }
}

/// Writes the world, and returns how it is run as it was.
std::string write_world(const RecordedRun& run, const std::string& file) {
  if (run.start_xml.empty()) {
    throw BadInput("--world: there is no world in the recording");
  }
  std::ofstream out(file);
  out << start_from(run, std::filesystem::path(file).parent_path());
  if (!out.flush()) {
    throw BadInput("--world: '" + file + "' cannot be written");
  }
  world::Element root = world::parse_markup(run.start_xml, file);
  const world::Element* const limits = root.child("limits");
  const world::Attribute* const time = limits ? limits->find("time") : nullptr;
  const double own_s = time ? parse_number(time->value).value_or(0.0) : world::Limits{}.time;
  return "the same run: elsie run " + file + " --seed " + std::to_string(run.seed) +
         (own_s == run.time_limit_s ? "" : " --duration " + base::number_text(run.time_limit_s)) +
         "\n\n";
}

}  // namespace

int replay_recording(const RecordingOptions& options) {
  if (options.picture) {
    require_picture(*options.picture, "--picture");
  }
  if (options.world) {
    require_writable(*options.world, "--world");
    if (std::filesystem::exists(*options.world)) {
      throw BadInput("--world: '" + *options.world + "' is there already; expected a new file");
    }
  }
  const RecordedRun run = read(options);
  if (options.picture) {
    draw(run, options);
  }
  const std::string again = options.world ? write_world(run, *options.world) : "";
  out() << again << report(run);
  return kSuccess;
}

}  // namespace elsie::program
