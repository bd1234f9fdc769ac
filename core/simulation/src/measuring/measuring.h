// The measures of a world at run time.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "measuring/lookout.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

class Measuring {
 public:
  /// Makes and equips the plugin objects; adds what they refuse to `problems`. The world must
  /// outlive this object and must not move.
  Measuring(const world::World& world, const plugin::Host& host, const Budget& budget,
            std::vector<base::Problem>& problems);

  bool empty() const { return slots_.empty(); }
  /// The values that the measures report, with their names in results.
  std::vector<Quantity> quantities() const;

  void reset(std::uint64_t seed);
  /// Collects the notes of the measures after a reset.
  void ask(Statements& said);
  /// Appends notes on what the measures changed in the program since the run began.
  void list_late_notes(std::vector<Note>& notes) const { guard_.list_notes(notes); }

  /// Takes over the measures of `before` whose descriptions are unchanged, if robots and obstacles
  /// are the same; `was` has the old descriptions.
  void take(const Measuring& before, std::span<const world::PluginUse> was, Undo& undo);
  /// Resets the measures that were not taken over, and collects their notes.
  void reset_new(std::uint64_t seed, const std::string& time, Statements& said);

  /// Returns whether all measures have had their first observation.
  bool has_begun() const;
  /// Calls observe() of the measures after the step with this number. `is_start`: the first call,
  /// only of measures that have not begun. Throws PluginFault.
  void observe(Robots robots, const physics::Engine& engine, double time_s, std::uint64_t step,
               bool decided, bool is_start);
  /// Appends the values so far. Throws PluginFault; after a failure all values are none, and
  /// measures are not called any more.
  void report(const RunEnd& end, std::vector<MeasuredValue>& values);

  /// Appends the curves so far. Throws PluginFault.
  void list_curves(std::vector<LearningCurve>& curves) const;

  /// See Simulation.
  void visit_published(const VisitPublished& visit) const;
  std::vector<PluginSketch> sketches() const;

  /// Measures are not replaced with their plugins: appends a sentence for each that differs in
  /// `host`.
  void list_replaced(const plugin::Host& host, std::vector<std::string>& notes);

 private:
  struct Slot final : ObjectOf<Measure, PluginKind::measure> {
    using ObjectOf::ObjectOf;

    std::vector<Quantity> quantities;  // under their full names
    std::vector<std::optional<double>> values;
    bool has_begun = false;
  };
  void check_names(std::vector<base::Problem>& problems) const;

  mutable Guard guard_;             // looking at a plugin can fail, too
  std::optional<Lookout> lookout_;  // with measures only
  std::vector<std::shared_ptr<Slot>> slots_;
  bool has_failed_ = false;
};

/// Adds the values that every run has. `departed`: the sums of robots that an edit removed.
void measure_every_run(RunResult& result, const Tally& departed);

}  // namespace elsie::simulation
