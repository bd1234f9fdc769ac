// Recording a run as an MCAP file. Its channels have Foxglove's schemas, so that viewers of such
// files should draw them as they are.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "elsie/simulation/observer.h"

namespace elsie::recording {

struct McapOptions {
  /// Samples per simulated second, rounded to whole steps, at most one a step; must be positive.
  double rate_hz = 10.0;
  /// What the cameras see, too, in each sample that has a new picture.
  bool images = false;
  /// How long each behaviour took to answer, too; only if the simulation measures it.
  bool with_times = false;
  /// Who records: "elsie 0.1.0".
  std::string program = "elsie";
};

/// Writes messages in JSON, whose schemas are in the file, and whose times are simulated ones. What
/// is in which channel is described in docs/recordings.md; read_recorded_run() reads it.
///
/// Poses and states are those of their time; readings, commands, traces and pictures those of the
/// decision that led there, whose time is their timestamp: before the first there are none. There
/// is a sample at the start, one per period, and one at the end. Events are written in the step in
/// which they happen, the whole scene whenever a box leaves it.
///
/// The file is written as the run goes: what was recorded is there after at most a simulated
/// second, at any rate, and can be read when the program is killed; when a plugin brings it down
/// (process::report_crashes()), all that was recorded until then. The same world, seed and options
/// give the same bytes (unless with_times). A recorder serves one run.
class McapRecorder final : public simulation::Observer {
 public:
  /// Creates the file at once, or empties it. Throws mcap::McapError when that cannot be done,
  /// std::invalid_argument for a rate that is not positive.
  explicit McapRecorder(const std::filesystem::path& file, McapOptions options = {});
  ~McapRecorder() override;

  // Each throws mcap::McapError when the file cannot be written (a full disk).
  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void ended(const simulation::Simulation& simulation) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::recording
