// Recording a run as a table.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "elsie/recording/formats.h"
#include "elsie/simulation/observer.h"

namespace elsie::recording {

/// Writes one row per robot and sample, comma-separated, with a heading line. Columns:
///
/// - time_s, robot, x_m, y_m, heading_rad, distance_m, energy;
/// - forward_m_s, lateral_m_s, turn_rad_s: the measured motion; with asked_ in front, the
///   motion that the coordinator asked for; with command_ in front, what the drive can make of it;
/// - sensor[ID].VALUE for each number of each sensor's reading;
/// - behavior[ID].asked, .forward_m_s, .lateral_m_s, .turn_rad_s, .activation, .strength, .weight,
///   .share, .inhibited_by, .reason (and .time_s when time is measured): the coordinator's trace of
///   its last decision.
///
/// Poses are those at time_s; readings, commands and traces are those of the decision that led
/// there, and empty in the first row, before any decision. Columns for what a robot does not have
/// stay empty. When plugins are replaced, numbers that sensors did not have at the start get no
/// columns. Numbers are written so that they read back the same, bit for bit. The file is written
/// during the run: after a plugin has failed, it is valid. A recorder serves one run.
class CsvRecorder final : public simulation::Observer {
 public:
  /// Creates the file at once; throws std::runtime_error with a sentence when it cannot.
  /// `rate_hz`: samples per simulated second, rounded to whole steps, at most one a step; must be
  /// positive.
  /// `robots`: ids of those that get rows; empty: all.
  CsvRecorder(const std::filesystem::path& file, double rate_hz, bool with_times = false,
              const std::vector<std::string>& robots = {});
  ~CsvRecorder() override;

  /// Its entry in the table of formats.
  static Format format();

  void started(const simulation::Simulation& simulation) override;
  void stepped(const simulation::Simulation& simulation) override;
  void replaced(const simulation::Simulation& simulation) override;
  /// Throws std::runtime_error when the file could not be written to its end (a full disk).
  void ended(const simulation::Simulation& simulation) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::recording
