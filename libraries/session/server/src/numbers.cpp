#include "numbers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "elsie/simulation/fault.h"
#include "elsie/world/parts.h"

namespace elsie::server {
namespace {

using simulation::RobotView;
using simulation::Simulation;

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// Sources that are no sensors: the fuzzy models of a robot, what its plugins publish, and measures.
constexpr std::size_t kNoSensor = std::numeric_limits<std::size_t>::max();
constexpr std::size_t kPublished = kNoSensor - 1;
constexpr std::size_t kGraphs = kNoSensor - 2;
constexpr std::size_t kNoRobot = std::numeric_limits<std::size_t>::max();

/// Takes the values, in the order of the names.
class Values {
 public:
  explicit Values(std::vector<float>& values) : values_(values) {}
  void begin(std::string_view /*prefix*/, std::string_view /*path*/ = {}) {}
  void see(std::string_view /*name*/, double value, std::string_view /*unit*/ = {}) {
    values_.push_back(static_cast<float>(value));
  }
  void see(const ReadingField& /*field*/, std::size_t /*i*/, double value) { see({}, value); }
  void see_joints(const RobotView& robot) {
    for (const JointSetting& joint : robot.joints) {
      see("rate", joint.rate_rad_s);
    }
  }

 private:
  std::vector<float>& values_;
};

/// Takes the names, and the units of those that have one.
class Names {
 public:
  Names(std::vector<std::string>& names, Numbers::Units& units) : names_(names), units_(units) {}
  void begin(std::string_view robot, std::string_view path = {}) {
    prefix_ = std::string(robot) + '/';
    prefix_ += path;
    prefix_ += path.empty() ? "" : "/";
  }
  void see(std::string_view name, double /*value*/, std::string_view unit = {}) {
    names_.push_back(prefix_ + std::string(name));
    if (!unit.empty()) units_.emplace(names_.back(), unit);
  }
  void see(const ReadingField& field, std::size_t i, double value) {
    see(field.column(i), value, field.unit);
  }
  void see_joints(const RobotView& robot) {
    std::size_t place = 0;
    for (const Part& part : world::plan_of(*robot.description).parts) {
      if (can_be_set(part.joint) && place < robot.joints.size()) {
        begin(robot.description->id, part.name);
        see("rate", robot.joints[place++].rate_rad_s, "rad/s");
      }
    }
  }

 private:
  std::vector<std::string>& names_;
  Numbers::Units& units_;
  std::string prefix_;
};

/// Visits all numbers of a robot except those of its sensors. `has_decided`: there are decisions.
template <class Visitor>
void visit(const Simulation& simulation, std::size_t index, bool has_decided, Visitor& visitor) {
  const RobotView robot = simulation.robot(index);
  const std::string& id = robot.description->id;
  const OwnState& state = *robot.state;
  const auto if_decided = [has_decided](double value) { return has_decided ? value : kNone; };
  visitor.begin(id);
  visitor.see("energy", state.capacity > 0.0 ? state.energy : kNone);
  visitor.see("distance", robot.distance_m, "m");
  visitor.see("speed", state.moving.forward, "m/s");
  visitor.see("collisions", robot.collisions);
  visitor.see("asked/forward", robot.asked.forward, "m/s");
  visitor.see("asked/lateral", robot.asked.lateral, "m/s");
  visitor.see("asked/turn", robot.asked.turn, "rad/s");
  visitor.see("possible/forward", robot.command.forward, "m/s");
  visitor.see("possible/lateral", robot.command.lateral, "m/s");
  visitor.see("possible/turn", robot.command.turn, "rad/s");
  visitor.see_joints(robot);
  for (const simulation::TracedMember& member : robot.trace) {
    const TraceRow& row = member.member->trace;
    visitor.begin(id, member.path);
    visitor.see("priority", member.member->priority());
    visitor.see("asked", if_decided(row.asked ? 1.0 : 0.0));
    visitor.see("activation", if_decided(row.activation));
    visitor.see("strength", if_decided(row.strength));
    visitor.see("weight", if_decided(row.weight));
    visitor.see("share", if_decided(row.share));
    visitor.see("command/forward", if_decided(row.command.forward), "m/s");
    visitor.see("command/lateral", if_decided(row.command.lateral), "m/s");
    visitor.see("command/turn", if_decided(row.command.turn), "rad/s");
  }
}

}  // namespace

template <class Visitor>
bool Numbers::visit_all(const Simulation& simulation, Visitor visitor) {
  const std::size_t failed = failed_.size();
  const bool has_decided = simulation.steps() > 0;
  for (std::size_t robot = 0; robot < simulation.robots(); ++robot) {
    visit(simulation, robot, has_decided, visitor);
    for (std::size_t i = 0; i < simulation.sensors(robot); ++i) {
      const auto lists_all = [&] { simulation.visit_reading(robot, i, [](const auto&) {}); };
      if (!succeeds({robot, i}, lists_all)) {
        continue;
      }
      visitor.begin(simulation.robot(robot).description->id, simulation.sensor(robot, i).id);
      simulation.visit_reading(robot, i, [&](const ReadingField& field) {
        for (std::size_t k = 0; field.is_number() && k < field.size; ++k) {
          visitor.see(field, k, has_decided && k < field.count ? field.number(k) : kNone);
        }
      });
    }
    for (std::size_t i = 0; i < simulation.actuators(robot); ++i) {
      const auto lists_all = [&] { simulation.visit_command(robot, i, [](const auto&) {}); };
      if (!succeeds({robot, simulation.sensors(robot) + i}, lists_all)) continue;
      visitor.begin(simulation.robot(robot).description->id, simulation.actuator(robot, i).id);
      simulation.visit_command(robot, i, [&](const ReadingField& field) {
        for (std::size_t k = 0; field.is_number() && k < field.size; ++k) {
          visitor.see(field, k, has_decided && k < field.count ? field.number(k) : kNone);
        }
      });
    }
    visit_published(
        simulation.robot(robot).description->id, {robot, kPublished},
        [&](const auto& visit) { simulation.visit_published(robot, visit); }, has_decided, visitor);
    visit_nodes(simulation, robot, has_decided, visitor);
  }
  visit_published(
      kMeasures, {kNoRobot, kPublished},
      [&](const auto& visit) { simulation.visit_published(visit); }, has_decided, visitor);
  return failed_.size() == failed;
}

template <class List, class Visitor>
void Numbers::visit_published(std::string_view whose, std::pair<std::size_t, std::size_t> source,
                              const List& list, bool has_decided, Visitor& visitor) {
  if (silent_.contains(source)) return;
  struct Number {
    std::string name;
    double value;
    std::string_view unit;
  };
  std::vector<Number> numbers;
  const auto list_all = [&] {
    list([&](const simulation::PublishedValue& each) {
      numbers.push_back(
          {std::string(each.path) + '/' + each.number.name, each.value, each.number.facts.unit});
    });
  };
  if (!succeeds(source, list_all)) return;
  if (numbers.empty()) silent_.insert(source);
  visitor.begin(whose);
  for (const Number& each : numbers) {
    visitor.see(each.name, has_decided ? each.value : kNone, each.unit);
  }
}

template <class Visitor>
void Numbers::visit_nodes(const Simulation& simulation, std::size_t robot, bool has_decided,
                          Visitor& visitor) {
  const std::pair source{robot, kGraphs};
  if (silent_.contains(source)) return;
  std::vector<simulation::LitGraph> graphs;
  if (!succeeds(source, [&] { graphs = simulation.graphs(robot); })) return;
  const auto [listed, is_new] = nodes_.try_emplace(robot);
  if (is_new) {
    std::size_t count = 0;
    for (const simulation::LitGraph& each : graphs) {
      listed->second.emplace_back(each.path, each.lights.size());
      count += each.lights.size();
    }
    if (count > kMostNodes) listed->second.clear();
    if (listed->second.empty()) silent_.insert(source);
  }
  for (std::size_t g = 0; g < listed->second.size(); ++g) {
    const auto& [path, count] = listed->second[g];
    visitor.begin(simulation.robot(robot).description->id, path);
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_there = has_decided && g < graphs.size() && i < graphs[g].lights.size();
      visitor.see("nodes/" + std::to_string(i),
                  is_there ? static_cast<double>(graphs[g].lights[i]) : kNone);
    }
  }
}

template <class Call>
bool Numbers::succeeds(std::pair<std::size_t, std::size_t> source, const Call& call) {
  if (failed_.contains(source)) {
    return false;
  }
  try {
    call();
    return true;
  } catch (const simulation::PluginFault& fault) {
    failed_.insert(source);
    if (noted_.emplace(fault.robot, fault.id).second) {
      notes_.push_back({fault.robot, fault.id,
                        std::string("its numbers are not stored from now on, until an edit or a "
                                    "reset: ") +
                            fault.what()});
    }
    return false;
  }
}

void Numbers::begin(const Simulation& simulation, double period_s) {
  samples_.begin(period_s);
  noted_.clear();
  notes_.clear();
  lay_out(simulation);
}

void Numbers::lay_out(const Simulation& simulation) {
  failed_.clear();
  silent_.clear();
  nodes_.clear();
  list_names(simulation);
}

void Numbers::list_names(const Simulation& simulation) {
  std::vector<std::string> names;
  units_.clear();
  visit_all(simulation, Names(names, units_));
  if (names_ && names.size() == fixed_ &&
      std::equal(names.begin(), names.end(), names_->names().begin())) {
    return;
  }
  fixed_ = names.size();
  further_.clear();
  set_names(std::move(names));
}

void Numbers::set_names(std::vector<std::string> names) {
  names_ = share(std::move(names));
  ++layout_;
}

void Numbers::add(const Simulation& simulation, bool with_measures, bool with_fuzzy) {
  std::vector<float> values;
  values.reserve(names_->names().size());
  while (!visit_all(simulation, Values(values))) {
    list_names(simulation);  // without what has failed
    values.clear();
  }
  add_further(simulation, with_measures, with_fuzzy, values);
  samples_.add({simulation.time_s(), names_, std::move(values)});
}

void Numbers::add_further(const Simulation& simulation, bool with_measures, bool with_fuzzy,
                          std::vector<float>& values) {
  std::vector<std::string> fresh;
  const auto put = [&](std::string name, double value) {
    const auto [place, is_new] =
        further_.try_emplace(std::move(name), names_->names().size() + fresh.size());
    if (is_new) {
      fresh.push_back(place->first);
    }
    if (values.size() <= place->second) {
      values.resize(place->second + 1, kNone);
    }
    values[place->second] = static_cast<float>(value);
  };
  for (std::size_t i = 0; with_fuzzy && i < simulation.robots(); ++i) {
    std::vector<simulation::MadeInference> all;
    succeeds({i, kNoSensor}, [&] { all = simulation.inferences(i); });
    std::map<std::string_view, int> counts;  // a behaviour may have several
    for (const simulation::MadeInference& made : all) {
      const int count = ++counts[made.path];
      const std::string prefix = simulation.robot(i).description->id + '/' + made.path +
                                 (count > 1 ? " (" + std::to_string(count) + ")/" : "/");
      for (const Inference::Value& each : made.inference.inputs) {
        put(prefix + "inputs/" + each.name, each.value);
      }
      for (const Inference::Value& each : made.inference.outputs) {
        put(prefix + "outputs/" + each.name, each.value);
      }
    }
  }
  if (with_measures && simulation.steps() > 0) {  // measures exist from the first step
    std::vector<simulation::MeasuredValue> all;
    succeeds({kNoRobot, kNoSensor}, [&] { all = simulation.measures(); });
    for (const simulation::MeasuredValue& measure : all) {
      const std::string name = std::string(kMeasures) + '/' + measure.name;
      if (!measure.unit.empty()) units_.emplace(name, measure.unit);
      put(name, measure.value.value_or(kNone));
    }
  }
  if (!fresh.empty()) {
    std::vector<std::string> names = names_->names();
    names.insert(names.end(), fresh.begin(), fresh.end());
    set_names(std::move(names));
  }
}

std::vector<float> Numbers::values(std::span<const std::string> names,
                                   std::span<const Sample> samples) {
  std::vector<float> values(names.size() * samples.size(), kNone);
  visit_places(names, samples, [&](std::size_t i, std::size_t k, std::size_t place) {
    if (place < samples[k].values.size()) {
      values[i * samples.size() + k] = samples[k].values[place];
    }
  });
  return values;
}

}  // namespace elsie::server
