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
  /// Makes and equips the plugin objects; adds to `problems` what they refuse. The world must stay
  /// where it is.
  Measuring(const world::World& world, const plugin::Host& host, const Budget& budget,
            std::vector<base::Problem>& problems);

  bool empty() const { return slots_.empty(); }
  /// What they report, under the names that it has in results.
  std::vector<Quantity> quantities() const;

  void reset(std::uint64_t seed);
  /// Gathers what the measures say once they are reset.
  void ask(Statements& said);
  /// What the measures did to the program since the run began.
  void list_late_notes(std::vector<Note>& notes) const { guard_.list_notes(notes); }

  /// Goes on with what `before` has of measures that are described as they were, if they find the
  /// same robots and boxes; `was` describes those.
  void take(const Measuring& before, std::span<const world::PluginUse> was, Undo& undo);
  /// Resets what was not taken, which begins with the next instant, and gathers what it says.
  void reset_new(std::uint64_t seed, const std::string& time, Statements& said);

  /// Whether all have seen the start of what they measure.
  bool has_begun() const;
  /// Shows them the instant after the step of this number; `is_start`: only those that have not
  /// begun, without that step. Throws PluginFault.
  void observe(Robots robots, const physics::Engine& engine, double time_s, std::uint64_t step,
               bool decided, bool is_start);
  /// Appends the values so far. Throws PluginFault; once a measure has failed, all values are none
  /// and nothing is asked any more.
  void report(const RunEnd& end, std::vector<MeasuredValue>& values);

  /// Measures stay what they are when plugins are replaced: a sentence for each of which `host` has
  /// another one.
  void list_replaced(const plugin::Host& host, std::vector<std::string>& notes);

 private:
  struct Slot final : ObjectOf<Measure, PluginKind::measure> {
    using ObjectOf::ObjectOf;

    std::vector<Quantity> quantities;  // under their full names
    std::vector<std::optional<double>> values;
    bool has_begun = false;
  };
  void check_names(std::vector<base::Problem>& problems) const;

  Guard guard_;
  Lookout lookout_;
  std::vector<std::shared_ptr<Slot>> slots_;
  bool has_failed_ = false;
};

/// Adds the values that every run has. `departed`: what robots did that an edit has removed.
void measure_every_run(RunResult& result, const Tally& departed);

}  // namespace elsie::simulation
