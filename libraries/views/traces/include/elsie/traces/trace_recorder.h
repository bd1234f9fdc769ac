// Writing the coordination trace of a run.
#pragma once

#include <filesystem>
#include <memory>

#include "elsie/simulation/observer.h"

namespace elsie::traces {

/// Writes what every coordinator decides: a line per behaviour and decision, left out where nothing
/// has changed. Besides: the commands that the motors get, and the events. The format, made for
/// people and for tables, is described in docs/explaining-a-run.md; read_trace() reads it.
///
/// Commands, activations, strengths and shares are rounded to three decimals, weights to four
/// significant digits; times are exact. CsvRecorder keeps every digit.
///
/// The file is written as the run goes, whole lines at a time, at least once per simulated second:
/// what is there when the program is killed is valid but for the last line, at the worst. A
/// recorder serves one run.
class TraceRecorder final : public simulation::Observer {
 public:
  /// Creates the file at once; a trace that is there already is overwritten. Throws
  /// std::runtime_error with a sentence when the file cannot be created, or when there is one of
  /// that name that is no trace. `with_times`: adds how long each behaviour took to answer; only if
  /// the simulation measures it.
  explicit TraceRecorder(const std::filesystem::path& file, bool with_times = false);
  ~TraceRecorder() override;

  void started(const simulation::Simulation& simulation) override;
  /// Throws std::runtime_error when the file cannot be written (a full disk).
  void stepped(const simulation::Simulation& simulation) override;
  /// Likewise.
  void ended(const simulation::Simulation& simulation) override;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace elsie::traces
