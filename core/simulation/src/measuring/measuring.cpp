#include "measuring/measuring.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "elsie/plugin/kind_name.h"
#include "elsie/simulation/measures.h"
#include "elsie/world/same.h"

namespace elsie::simulation {
namespace {

bool may_be_in_a_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         c == '-' || c == '.' || c == '/';
}

/// The quantities of a measure with their full names. Throws std::invalid_argument.
std::vector<Quantity> full_names(const world::PluginUse& use, std::vector<Quantity> quantities) {
  if (quantities.empty()) throw std::invalid_argument("it has no values to report in this world");
  for (Quantity& quantity : quantities) {
    if (!std::all_of(quantity.name.begin(), quantity.name.end(), may_be_in_a_name)) {
      throw std::invalid_argument("it calls a value '" + quantity.name +
                                  "'; expected letters, digits, '_', '-', '.' and '/'");
    }
    quantity.name = quantity.name.empty() ? use.id : use.id + "." + quantity.name;
  }
  return quantities;
}

double sum(const RunResult& result, double (*of)(const RobotResult&)) {
  double all = 0.0;
  for (const RobotResult& robot : result.robots) {
    all += of(robot);
  }
  return all;
}

}  // namespace

std::vector<Quantity> measures_of_every_run() {
  return {{"success", "", "1 when the goals were reached, else 0"},
          {"time_s", "s", "simulated time"},
          {"path_length_m", "m", "distance driven by all robots"},
          {"collected", "", "resources collected by all robots"},
          {"collisions", "", "collisions of all robots; one between two robots counts twice"},
          {"energy_left", "units", "energy left in all batteries at the end"}};
}

void measure_every_run(RunResult& result, const Tally& departed) {
  const double values[kMeasuresOfEveryRun] = {
      result.outcome == Outcome::success ? 1.0 : 0.0,
      result.simulated_s,
      departed.distance_m + sum(result, [](const RobotResult& robot) { return robot.distance_m; }),
      departed.collected +
          sum(result, [](const RobotResult& robot) { return double(robot.collected); }),
      departed.collisions +
          sum(result, [](const RobotResult& robot) { return double(robot.collisions); }),
      sum(result, [](const RobotResult& robot) { return robot.energy; })};
  std::size_t i = 0;
  for (Quantity& quantity : measures_of_every_run()) {
    const double value = values[i++];
    // A physics engine that failed may leave values that are not finite.
    result.measures.push_back({std::move(quantity.name), std::move(quantity.unit),
                               std::move(quantity.meaning),
                               std::isfinite(value) ? std::optional(value) : std::nullopt});
  }
}

std::vector<Quantity> measure_names(const world::World& world, const plugin::Host& host) {
  std::vector<base::Problem> problems;
  const Measuring measuring(world, host, {}, problems);
  if (!problems.empty()) throw world::WorldError(std::move(problems));
  std::vector<Quantity> all = measures_of_every_run();
  for (Quantity& quantity : measuring.quantities()) {
    all.push_back(std::move(quantity));
  }
  return all;
}

Measuring::Measuring(const world::World& world, const plugin::Host& host, const Budget& budget,
                     std::vector<base::Problem>& problems, const Measuring* before)
    : guard_("", budget) {
  if (!world.measures.empty() || !world.rules.empty()) {
    lookout_.emplace(world, host, [this](const auto& visit) { visit_published(visit); });
  }
  for (const world::PluginUse& use : world.measures) {
    add(PluginKind::measure, use, host, problems);
  }
  for (const world::PluginUse& use : world.rules) {
    if (before && before->slot_of(PluginKind::rule, use)) {
      slots_.push_back(std::make_shared<Slot>(PluginKind::rule, use, host));  // for take()
    } else {
      add(PluginKind::rule, use, host, problems);
    }
  }
  check_names(problems);
}

void Measuring::add(PluginKind kind, const world::PluginUse& use, const plugin::Host& host,
                    std::vector<base::Problem>& problems) {
  Slot& slot = *slots_.emplace_back(std::make_shared<Slot>(kind, use, host));
  slot.make(host, problems);
  if (!slot.held) return;
  slot.quantities = blaming(use, problems, [&]() -> std::vector<Quantity> {
    if (kind == PluginKind::rule) {
      slot.rule().equipped(lookout_->now());
      return {};
    }
    slot.measure().equipped(lookout_->now());
    return full_names(use, slot.measure().quantities());
  });
  slot.values.resize(slot.quantities.size());
}

plugin::Object<Component> Measuring::Slot::create(const plugin::Host& host) const {
  if (kind == PluginKind::rule) return host.create<Rule>(kind, use->plugin);
  return host.create<Measure>(kind, use->plugin);
}

std::string Measuring::Slot::path() const {
  return std::string(plugin::kind_name(kind)) + "[" + use->id + "]";
}

/// Checks that all values have different names.
void Measuring::check_names(std::vector<base::Problem>& problems) const {
  std::set<std::string> of_every_run;
  for (const Quantity& quantity : measures_of_every_run()) {
    of_every_run.insert(quantity.name);
  }
  std::set<std::string> taken = of_every_run;
  for (const auto& slot : slots_) {
    for (const Quantity& quantity : slot->quantities) {
      if (!taken.insert(quantity.name).second) {
        problems.push_back({slot->use->location.file, slot->use->location.line,
                            "plugin '" + slot->use->plugin +
                                "': one of its values would be called '" + quantity.name +
                                "', as " +
                                (of_every_run.contains(quantity.name) ? "a value that every run has"
                                                                      : "another one is already") +
                                "; give it another id"});
      }
    }
  }
}

std::vector<Quantity> Measuring::quantities() const {
  std::vector<Quantity> all;
  for (const auto& slot : slots_) {
    all.insert(all.end(), slot->quantities.begin(), slot->quantities.end());
  }
  return all;
}

void Measuring::reset(std::uint64_t seed) {
  guard_.begin_run();
  guard_.begin_step(0, 0.0);
  has_failed_ = false;
  for (const auto& slot : slots_) {
    slot->has_begun = false;
    slot->rebuilt = 0;
    guard_.run(*slot->use, [&] { slot->reset(seed, slot->path()); });
  }
}

void Measuring::ask(Statements& said) {
  for (const auto& slot : slots_) {
    said.ask_notes(*slot, guard_);
  }
}

void Measuring::list_curves(std::vector<LearningCurve>& curves) const {
  if (has_failed_) return;
  Statements said;
  for (const auto& slot : slots_) said.ask_curves(*slot, "", guard_);
  std::move(said.curves.begin(), said.curves.end(), std::back_inserter(curves));
}

void Measuring::list_late_notes(std::vector<Note>& notes) const {
  constexpr std::uint64_t kMany = 10;
  guard_.list_notes(notes);
  for (const auto& slot : slots_) {
    if (slot->rebuilt < kMany) continue;
    notes.push_back({"", slot->use->id,
                     "its edits made objects or bodies again " + std::to_string(slot->rebuilt) +
                         " times, which is slow; docs/changing-a-world.md lists edits that cost "
                         "nothing"});
  }
}

void Measuring::note_rebuilt(const std::string& rule) {
  for (const auto& slot : slots_) {
    if (slot->kind == PluginKind::rule && slot->use->id == rule) ++slot->rebuilt;
  }
}

void Measuring::take(const Measuring& before, bool same_stage, Undo& undo) {
  if (!lookout_ || !before.lookout_) return;
  const bool may_measure = same_stage && lookout_->has_cast_of(*before.lookout_);
  has_failed_ = may_measure && before.has_failed_;
  for (auto& slot : slots_) {
    if (!may_measure && slot->kind == PluginKind::measure) continue;
    if (const auto known = before.slot_of(slot->kind, *slot->use)) {
      const world::PluginUse* const use = slot->use;
      slot = known;
      undo.keep(slot->use);
      slot->use = use;
    }
  }
}

std::shared_ptr<Measuring::Slot> Measuring::slot_of(PluginKind kind,
                                                    const world::PluginUse& use) const {
  const auto found = std::find_if(slots_.begin(), slots_.end(), [&](const auto& slot) {
    return slot->kind == kind && slot->use->id == use.id && world::same(*slot->use, use);
  });
  return found == slots_.end() ? nullptr : *found;
}

void Measuring::reset_new(std::uint64_t seed, const std::string& time, Statements& said) {
  for (const auto& slot : slots_) {
    if (slot->is_new) {
      guard_.run(*slot->use, [&] { slot->reset(seed, slot->path()); });
      said.ask_notes(*slot, guard_);
      said.notes.push_back({"", slot->use->id,
                            (slot->kind == PluginKind::rule ? "it rules" : "it measures") +
                                std::string(" from an edit of the world at ") + time + " on"});
    }
  }
}

bool Measuring::has_begun(PluginKind kind) const {
  return std::all_of(slots_.begin(), slots_.end(),
                     [&](const auto& slot) { return slot->has_begun || slot->kind != kind; });
}

void Measuring::look(Robots robots, const physics::Engine& engine, const Fields& fields,
                     std::span<const EventRecord> events, double time_s, std::uint64_t step,
                     bool decided, bool is_start) {
  guard_.begin_step(step, time_s);
  if (lookout_) lookout_->look(robots, engine, fields, events, time_s, decided, is_start);
}

template <class Call>
void Measuring::call(PluginKind kind, bool is_start, const Call& call) {
  for (const auto& slot : slots_) {
    if (slot->kind != kind || (is_start && slot->has_begun)) continue;
    slot->has_begun = true;
    try {
      guard_.step(*slot, [&] { call(*slot); });
    } catch (...) {
      has_failed_ = true;
      throw;
    }
  }
}

void Measuring::observe(bool is_start) {
  call(PluginKind::measure, is_start,
       [this](const Slot& slot) { slot.measure().observe(lookout_->now()); });
}

void Measuring::apply(RuleAnswers& answers, bool is_start) {
  call(PluginKind::rule, is_start, [&](const Slot& slot) {
    answers.begin(slot);
    slot.rule().apply(lookout_->now(), answers);
  });
}

void Measuring::report(const RunEnd& end, std::vector<MeasuredValue>& values) {
  for (const auto& each : slots_) {
    Slot& slot = *each;
    if (slot.kind == PluginKind::rule) continue;
    std::fill(slot.values.begin(), slot.values.end(), std::nullopt);
    if (!has_failed_) {
      try {
        guard_.run(*slot.use, [&] { slot.measure().report(end, slot.values); });
        for (std::size_t i = 0; i < slot.values.size(); ++i) {
          if (slot.values[i] && !std::isfinite(*slot.values[i])) {
            guard_.fail(*slot.use, "its value '" + slot.quantities[i].name +
                                       "' is not a finite number; leave out what has no value");
          }
        }
      } catch (...) {
        has_failed_ = true;
        throw;
      }
    }
    for (std::size_t i = 0; i < slot.values.size(); ++i) {
      const Quantity& quantity = slot.quantities[i];
      values.push_back({quantity.name, quantity.unit, quantity.meaning, slot.values[i]});
    }
  }
}

void Measuring::visit_published(const VisitPublished& visit) const {
  for (const auto& slot : slots_) {
    list_published(*slot, "", guard_, visit);
  }
}

std::vector<PluginSketch> Measuring::sketches() const {
  std::vector<PluginSketch> sketches;
  for (const auto& slot : slots_) {
    add_sketch(*slot, "", {}, guard_, sketches);
  }
  return sketches;
}

void Measuring::list_replaced(const plugin::Host& host, std::vector<std::string>& notes) {
  for (const auto& slot : slots_) {
    const Declaration* const now = host.find(slot->kind, slot->use->plugin);
    if (now != slot->declaration) {
      notes.push_back("the " + std::string(plugin::kind_name(slot->kind)) + " '" + slot->use->id +
                      "' stays as it was when the world was made; a new one would not know the "
                      "run so far");
      slot->declaration = now;
    }
  }
}

}  // namespace elsie::simulation
