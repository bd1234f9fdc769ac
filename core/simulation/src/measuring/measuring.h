// The measures and rules of a world at run time: what sees all of it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "elsie/api/measure.h"
#include "elsie/api/rule.h"
#include "elsie/physics/engine.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/run_result.h"
#include "elsie/simulation/simulation.h"
#include "elsie/world/description.h"
#include "elsie/world/error.h"

#include "measuring/lookout.h"
#include "measuring/rule_answers.h"
#include "plugins/plugin_object.h"

namespace elsie::simulation {

class Measuring {
 public:
  /// Makes and equips the plugin objects; adds what they refuse to `problems`. The world must
  /// outlive this object and must not move. `before`: take() follows, with its unchanged rules.
  Measuring(const world::World& world, const plugin::Host& host, const Budget& budget,
            std::vector<base::Problem>& problems, const Measuring* before = nullptr);

  bool empty() const { return slots_.empty(); }
  bool has_rules() const { return !empty() && slots_.back()->kind == PluginKind::rule; }
  /// The values that the measures report, with their names in results.
  std::vector<Quantity> quantities() const;

  void reset(std::uint64_t seed);
  /// Collects their notes after a reset.
  void ask(Statements& said);
  /// Appends notes on what they changed in the program since the run began, and on rules whose
  /// edits were costly.
  void list_late_notes(std::vector<Note>& notes) const;

  /// Takes over the objects of `before` whose descriptions are unchanged; measures only if robots,
  /// obstacles and the rest of the world (`same_stage`) are the same.
  void take(const Measuring& before, bool same_stage, Undo& undo);
  /// Resets the objects that were not taken over, and collects their notes.
  void reset_new(std::uint64_t seed, const std::string& time, Statements& said);

  /// Returns whether all of a kind have had their first observation.
  bool has_begun(PluginKind kind) const;
  /// Looks at the world after the step with this number. `events`: since the last look.
  void look(Robots robots, const physics::Engine& engine, const Fields& fields,
            std::span<const EventRecord> events, double time_s, std::uint64_t step, bool decided,
            bool is_start);
  /// Calls observe() of the measures. `is_start`: the first call, only of measures that have not
  /// begun. Throws PluginFault.
  void observe(bool is_start);
  /// The same for apply() of the rules.
  void apply(RuleAnswers& answers, bool is_start);
  /// An edit has put a box elsewhere.
  void place_box(std::size_t index, const Pose& pose) {
    if (lookout_) lookout_->place_box(index, pose);
  }
  /// An edit of the rule with this id has made objects or bodies again.
  void note_rebuilt(const std::string& rule);
  /// Appends the values so far. Throws PluginFault; after a failure all values are none, and
  /// measures are not called any more.
  void report(const RunEnd& end, std::vector<MeasuredValue>& values);

  /// Appends the curves so far. Throws PluginFault.
  void list_curves(std::vector<LearningCurve>& curves) const;

  /// See Simulation.
  void visit_published(const VisitPublished& visit) const;
  std::vector<PluginSketch> sketches() const;

  /// They are not replaced with their plugins: appends a sentence for each that differs in `host`.
  void list_replaced(const plugin::Host& host, std::vector<std::string>& notes);

 private:
  struct Slot final : PluginObject {
    using PluginObject::PluginObject;
    plugin::Object<Component> create(const plugin::Host& host) const override;
    Measure& measure() const { return static_cast<Measure&>(*held); }
    Rule& rule() const { return static_cast<Rule&>(*held); }
    /// "measure[home]"
    std::string path() const;

    bool has_begun = false;
    std::vector<Quantity> quantities;  // of a measure, under their full names
    std::vector<std::optional<double>> values;
    std::uint64_t rebuilt = 0;  // how often edits of a rule made objects or bodies again
  };
  void add(PluginKind kind, const world::PluginUse& use, const plugin::Host& host,
           std::vector<base::Problem>& problems);
  template <class Call>
  void call(PluginKind kind, bool is_start, const Call& call);
  /// The object of the same description, or null.
  std::shared_ptr<Slot> slot_of(PluginKind kind, const world::PluginUse& use) const;
  void check_names(std::vector<base::Problem>& problems) const;

  mutable Guard guard_;                       // looking at a plugin can fail, too
  std::optional<Lookout> lookout_;            // if there are any
  std::vector<std::shared_ptr<Slot>> slots_;  // rules after measures
  bool has_failed_ = false;
};

/// Adds the values that every run has. `departed`: the sums of robots that an edit removed.
void measure_every_run(RunResult& result, const Tally& departed);

}  // namespace elsie::simulation
