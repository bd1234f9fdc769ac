// A run read back from an MCAP file that McapRecorder wrote: what it was, what is in the file, and
// what the world looked like at any time of it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elsie/picture/size.h"
#include "elsie/picture/top_view.h"

namespace elsie::recording {

/// A channel of the file.
struct RecordedChannel {
  std::string topic;
  std::string schema;  // its name
  std::uint64_t messages = 0;
};

/// How the run ended.
struct RecordedResult {
  std::string outcome;  // "success", "failure", "time_limit", or "stopped": by a failing plugin or
                        // by the user
  std::string reason;
  double simulated_s = 0.0;
  std::uint64_t steps = 0;
  std::string state_hash;  // 16 hexadecimal digits
  std::map<std::string, double>
      measures;  // by name, as in simulation::RunResult; those with a value
};

struct RecordedRun {
  std::string library;  // which program wrote the file
  std::vector<RecordedChannel> channels;
  std::uint64_t messages = 0;
  double end_s = 0.0;       // the last message's time
  std::string missing_end;  // a sentence, where the file breaks off; empty: it is whole

  /// Whether Elsie recorded it. Otherwise there is none of what follows.
  bool of_elsie = false;
  std::string world;  // its name
  std::string world_file;
  std::string world_xml;  // the file's text, templates merged in
  std::uint64_t seed = 0;
  double time_limit_s = 0.0;  // of the run, which may differ from the world's
  double step_s = 0.0;
  double period_s = 0.0;                 // from one sample to the next
  std::optional<RecordedResult> result;  // none: the file has no end

  // As things were at the time asked for.
  double shown_s = 0.0;                     // of the last sample until then
  std::vector<picture::RobotTrack> robots;  // their ways until then
  std::map<std::string, Pose> moved;        // boxes that may move, by their ids
  std::set<std::string> standing;           // ids of the boxes that were not yet collected
};

/// Reads a file to its end, whether it is whole or breaks off. `until_s`: the time for which the
/// robots' ways and the boxes are wanted. Throws mcap::McapError for a file that cannot be read or
/// is damaged, with a sentence.
RecordedRun read_recorded_run(const std::filesystem::path& file,
                              double until_s = std::numeric_limits<double>::infinity());

/// Draws the world as it was, from what is in the file alone: no plugin, no world file is needed.
/// Throws world::WorldError when the world's text cannot be read (a file of a later version), and
/// as picture::save_top_view().
void save_picture(const RecordedRun& run, const std::vector<std::string>& subtitles,
                  const std::filesystem::path& file, const picture::Size& size = {});

}  // namespace elsie::recording
