// A run read back from an MCAP file of mcap_recorder(): the run, the contents of the file, the
// state of the world at any time, and who decided when.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "elsie/picture/graph_picture.h"
#include "elsie/picture/size.h"
#include "elsie/picture/top_view.h"
#include "elsie/traces/trace.h"

namespace elsie::plugin {
class Host;
}

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
  // Unknown (0 and empty) when a plugin crashed the program.
  std::uint64_t steps = 0;
  std::string state_hash;  // 16 hexadecimal digits
  std::map<std::string, double>
      measures;  // by name, as in simulation::RunResult; those with a value
};

/// The graphs of a robot's coordinators.
struct RecordedGraphs {
  std::vector<picture::NamedGraph> graphs;
  picture::GraphLights lights;
};

/// What happened to a robot or, with an empty `robot`, to the world.
struct RecordedEvent {
  double time_s = 0.0;
  std::string robot;  // its id
  std::string name;
  std::string detail;
  bool is_warning = false;
};

struct RecordedRun {
  std::string library;  // the program that wrote the file
  std::vector<RecordedChannel> channels;
  std::uint64_t messages = 0;
  double end_s = 0.0;       // the last message's time
  std::string missing_end;  // a sentence if the file breaks off; empty: it is complete

  /// True if Elsie recorded it. Otherwise the rest is empty.
  bool of_elsie = false;
  std::string world;  // its name
  std::string world_file;
  std::string world_xml;  // the file's text, templates merged in
  std::string start_xml;  // the same at the start, with all edits of the run among its changes
  std::vector<std::string> crowd;  // ids of the robots of which only the poses were recorded
  std::uint64_t seed = 0;
  double time_limit_s = 0.0;  // of the run, which may differ from the world's
  double step_s = 0.0;
  std::uint64_t control_steps = 0;       // from one decision to the next
  std::uint64_t sample_steps = 0;        // from one sample to the next
  double period_s = 0.0;                 // likewise, s
  std::optional<RecordedResult> result;  // none: the file has no end

  // The state at the requested time.
  double shown_s = 0.0;                               // of the last sample until then
  std::vector<picture::RobotTrack> robots;            // their paths until then
  std::map<std::string, RecordedGraphs> graphs;       // of robots that have any, by their ids
  std::vector<Sketch> sketches;                       // of measures
  std::map<std::string, picture::FloorField> fields;  // by their ids, without their colours
  std::map<std::string, Pose> moved;                  // boxes that were seen, by their ids
  /// Where they began: in the file, or where a rule or an edit put them last.
  std::map<std::string, Pose> starts;
  std::set<std::string> standing;     // ids of the boxes that were not yet collected
  std::vector<RecordedEvent> events;  // until then, ascending in time
};

/// Reads a file to its end, whether it is whole or breaks off. `until_s`: the time for which robots
/// and boxes are requested. Throws mcap::McapError with a sentence for a file that cannot be read
/// or is damaged.
RecordedRun read_recorded_run(const std::filesystem::path& file,
                              double until_s = std::numeric_limits<double>::infinity());

/// The same to the end of the file, and calls `see` with the state at each sample, in order, when
/// everything about its time has been read.
RecordedRun watch_recorded_run(const std::filesystem::path& file,
                               const std::function<void(const RecordedRun&)>& see);

/// Reads who decided when. A file that breaks off is read as far as it goes, see Trace::cut_off.
/// Throws mcap::McapError like read_recorded_run(), and for a file that Elsie did not record or
/// that breaks off before its first message.
traces::Trace read_trace(const std::filesystem::path& file);

/// Draws the world as it was. This does not need the world's file, and no plugins except drives; a
/// robot whose drive is missing is drawn on the default one. Throws world::WorldError when the
/// world's text cannot be read (a file of a later version), and
/// as picture::save_top_view().
void save_picture(const RecordedRun& run, const plugin::Host& drives,
                  const std::vector<std::string>& subtitles, const std::filesystem::path& file,
                  const picture::Size& size = {});
/// The same picture as the text of an SVG.
std::string picture_svg(const RecordedRun& run, const plugin::Host& drives,
                        const std::vector<std::string>& subtitles, const picture::Size& size = {});

}  // namespace elsie::recording
