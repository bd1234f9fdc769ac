// elsie.Simulation: a run that Python drives.
#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/simulation/run.h"
#include "elsie/simulation/simulation.h"
#include "elsie/traces/account_recorder.h"
#include "elsie/traces/tracks.h"

#include "bindings.h"
#include "made.h"
#include "tables.h"
#include "world.h"

namespace elsie::python {

/// What a simulation is made with, besides its world.
struct SimulationOptions {
  std::uint64_t seed = 1;
  std::size_t threads = 1;
  std::optional<double> time_limit_s{};  // s, instead of the world's
  std::vector<std::string> edits{};      // of the world, before the run
  bool trace = false;                    // sums up who decides
  bool paths = false;                    // keeps the paths of robots, for pictures
};

/// A simulation and its run, which begins with the first step. Members are called with the GIL;
/// advance() gives it away. While it does, every other member throws base::Error: nobody sees the
/// middle of a step.
class Simulation : public Made {
 public:
  Simulation(const World& world, const SimulationOptions& options);
  ~Simulation();

  /// The simulation between two steps, for other parts of this module.
  simulation::Simulation& now() {
    require_idle();
    return *simulation_;
  }
  const std::shared_ptr<const plugin::Host>& shared_host() const { return host_; }

  /// Makes so many steps, fewer if `until_s` comes or the run ends before; returns how many. Throws
  /// the fault that ended the run, again at every call.
  std::uint64_t advance(std::uint64_t steps, double until_s);
  /// Ends the run: recordings are complete then. Returns the result.
  simulation::RunResult end();
  /// Starts again at time zero with this seed; edits, recordings and observers are forgotten.
  void reset(std::optional<std::uint64_t> seed);
  /// The edits are made together, or none. Throws simulation::EditRefused.
  void edit(const std::vector<std::pair<std::string, std::string>>& edits);
  /// Records the run from its start. Throws base::BadInput after that.
  void record(const std::string& file, double rate_hz, bool images,
              const std::vector<std::string>& robots);

  /// A view of the table of this name, which is made at the first call and filled after every
  /// advance(), reset() and edit().
  using MakeTable = Table (*)(const simulation::Simulation& now, const std::string& name);
  py::array table(MakeTable make, const std::string& name);

  /// Who decided, of a run that has ended or failed; null without SimulationOptions::trace, or
  /// before the end.
  std::shared_ptr<const traces::AccountRecorder> account() const {
    return is_closed_ || failure_ ? account_ : nullptr;
  }
  /// What recorders had to say.
  const std::vector<std::string>& warnings() const {
    require_idle();
    return warnings_;
  }
  const traces::TrackRecorder* tracks() const { return tracks_.get(); }

 private:
  class Watcher;

  void require_idle() const;
  void begin();
  std::uint64_t steps_until(std::uint64_t steps, double until_s);
  /// Fills all tables, which have another form if there are other robots or sensors.
  /// Throws the first fault of a plugin that is asked, when all others are filled.
  void refresh();

  std::shared_ptr<const plugin::Host> host_;
  std::unique_ptr<World> drawn_;  // to draw its layouts again; null: it has none
  SimulationOptions options_;
  std::unique_ptr<simulation::Simulation> simulation_;
  std::shared_ptr<traces::AccountRecorder> account_;
  std::unique_ptr<traces::TrackRecorder> tracks_;
  std::unique_ptr<Watcher> watcher_;
  std::vector<std::string> warnings_;  // recorders may add some until they are destroyed
  std::vector<std::unique_ptr<simulation::Observer>> recorders_;
  std::unique_ptr<simulation::Run> run_;
  std::map<std::pair<MakeTable, std::string>, Table> tables_;
  bool is_stepping_ = false;
  bool is_closed_ = false;
  std::exception_ptr failure_;  // that ended the run, or kept it from beginning
};

}  // namespace elsie::python
