// Recording a run as an MCAP file. Its channels have Foxglove's schemas, so that viewers of such
// files can draw them.
#pragma once

#include <filesystem>
#include <memory>

#include "elsie/recording/formats.h"
#include "elsie/simulation/observer.h"

namespace elsie::recording {

/// Writes messages in JSON, with their schemas and simulated times. docs/recordings.md describes
/// the channels. read_recorded_run() and read_trace() read the file.
///
/// There is a sample at the start, one per period, and one at the end. Poses and states are those
/// at the sample's time; readings, commands and pictures are those of the decision that led there,
/// so that the first sample has none. Every decision that differs from the one before is written
/// when it is made, see trace_rows.h. Events are written in the step in which they happen, the
/// whole scene whenever a box leaves it.
///
/// The file is written during the run: a message is in the file after at most one simulated second,
/// also when the program is killed. When a plugin brings the program down, everything until then is
/// kept (process::report_crashes()). The same world, seed and options give the same bytes (unless
/// with_times). A recorder serves one run.
///
/// Creates the file at once, or empties it. Throws mcap::McapError when that cannot be done,
/// std::invalid_argument for a rate that is not positive; the recorder throws mcap::McapError when
/// the file cannot be written (a full disk).
std::unique_ptr<simulation::Observer> mcap_recorder(const std::filesystem::path& file,
                                                    const RecorderOptions& options = {});

/// Its entry in the table of formats.
Format mcap_format();

}  // namespace elsie::recording
