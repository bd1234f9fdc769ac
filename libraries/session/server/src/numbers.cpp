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

/// Takes the values, in the order of the names.
class Values {
 public:
  explicit Values(std::vector<float>& values) : values_(values) {}
  void begin(std::string_view /*prefix*/, std::string_view /*path*/ = {}) {}
  void see(std::string_view /*name*/, double value) {
    values_.push_back(static_cast<float>(value));
  }
  void see_joints(const RobotView& robot) {
    for (const JointSetting& joint : robot.joints) {
      see("rate", joint.rate_rad_s);
    }
  }

 private:
  std::vector<float>& values_;
};

/// Takes the names.
class Names {
 public:
  explicit Names(std::vector<std::string>& names) : names_(names) {}
  void begin(std::string_view robot, std::string_view path = {}) {
    prefix_ = std::string(robot) + '/';
    prefix_ += path;
    prefix_ += path.empty() ? "" : "/";
  }
  void see(std::string_view name, double /*value*/) {
    names_.push_back(prefix_ + std::string(name));
  }
  void see_joints(const RobotView& robot) {
    std::size_t place = 0;
    for (const Part& part : world::plan_of(*robot.description).parts) {
      if (can_be_set(part.joint) && place < robot.joints.size()) {
        begin(robot.description->id, part.name);
        see("rate", robot.joints[place++].rate_rad_s);
      }
    }
  }

 private:
  std::vector<std::string>& names_;
  std::string prefix_;
};

/// Visits all numbers of a robot. `has_decided`: there are decisions and measurements.
template <class Visitor>
void visit(const Simulation& simulation, std::size_t index, bool has_sensors, bool has_decided,
           std::vector<NamedValue>& listed, Visitor& visitor) {
  const RobotView robot = simulation.robot(index);
  const std::string& id = robot.description->id;
  const OwnState& state = *robot.state;
  const auto if_decided = [has_decided](double value) { return has_decided ? value : kNone; };
  visitor.begin(id);
  visitor.see("energy", state.capacity > 0.0 ? state.energy : kNone);
  visitor.see("distance", robot.distance_m);
  visitor.see("speed", state.moving.forward);
  visitor.see("collisions", robot.collisions);
  visitor.see("asked/forward", robot.asked.forward);
  visitor.see("asked/lateral", robot.asked.lateral);
  visitor.see("asked/turn", robot.asked.turn);
  visitor.see("possible/forward", robot.command.forward);
  visitor.see("possible/lateral", robot.command.lateral);
  visitor.see("possible/turn", robot.command.turn);
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
    visitor.see("command/forward", if_decided(row.command.forward));
    visitor.see("command/lateral", if_decided(row.command.lateral));
    visitor.see("command/turn", if_decided(row.command.turn));
  }
  for (std::size_t i = 0; has_sensors && i < simulation.sensors(index); ++i) {
    listed.clear();
    simulation.list_values(index, i, listed);
    visitor.begin(id, simulation.sensor(index, i).id);
    for (const NamedValue& value : listed) {
      visitor.see(value.name, if_decided(value.value));
    }
  }
}

template <class Visitor>
void visit(const Simulation& simulation, bool has_sensors, Visitor visitor) {
  std::vector<NamedValue> listed;
  for (std::size_t i = 0; i < simulation.robots(); ++i) {
    visit(simulation, i, has_sensors, simulation.steps() > 0, listed, visitor);
  }
}

}  // namespace

void Numbers::begin(const Simulation& simulation, double period_s) {
  samples_.begin(period_s);
  has_sensors_ = true;
  lay_out(simulation);
}

void Numbers::lay_out(const Simulation& simulation) {
  std::vector<std::string> names;
  try {
    visit(simulation, has_sensors_, Names(names));
  } catch (const simulation::PluginFault&) {
    has_sensors_ = false;
    lay_out(simulation);
    return;
  }
  if (names_ && names.size() == fixed_ && std::equal(names.begin(), names.end(), names_->begin())) {
    return;
  }
  fixed_ = names.size();
  further_.clear();
  set_names(std::move(names));
}

void Numbers::set_names(std::vector<std::string> names) {
  names_ = std::make_shared<const std::vector<std::string>>(std::move(names));
  ++layout_;
}

void Numbers::add(const Simulation& simulation, bool with_measures, bool with_fuzzy) {
  std::vector<float> values;
  values.reserve(names_->size());
  try {
    visit(simulation, has_sensors_, Values(values));
  } catch (const simulation::PluginFault&) {
    has_sensors_ = false;
    lay_out(simulation);
    add(simulation, with_measures, with_fuzzy);
    return;
  }
  add_further(simulation, with_measures, with_fuzzy, values);
  samples_.add({simulation.time_s(), names_, std::move(values)});
}

void Numbers::add_further(const Simulation& simulation, bool with_measures, bool with_fuzzy,
                          std::vector<float>& values) {
  for (std::size_t i = 0; with_fuzzy && i < simulation.robots(); ++i) {
    for (const simulation::MadeInference& made : simulation.inferences(i)) {
      const std::string prefix = simulation.robot(i).description->id + '/' + made.path + '/';
      for (const Inference::Value& each : made.inference.inputs) {
        put(prefix + "inputs/" + each.name, each.value, values);
      }
      for (const Inference::Value& each : made.inference.outputs) {
        put(prefix + "outputs/" + each.name, each.value, values);
      }
    }
  }
  if (with_measures && simulation.steps() > 0) {  // measures exist from the first step
    for (const simulation::MeasuredValue& measure : simulation.measures()) {
      put(std::string(kMeasures) + '/' + measure.name, measure.value.value_or(kNone), values);
    }
  }
}

void Numbers::put(const std::string& name, double value, std::vector<float>& values) {
  const auto [place, is_new] = further_.try_emplace(name, names_->size());
  if (is_new) {
    std::vector<std::string> names = *names_;
    names.push_back(name);
    set_names(std::move(names));
  }
  if (values.size() <= place->second) {
    values.resize(place->second + 1, kNone);
  }
  values[place->second] = static_cast<float>(value);
}

std::vector<std::vector<float>> Numbers::values(std::span<const std::string> names,
                                                std::span<const Sample> samples) {
  std::vector<std::vector<float>> columns(names.size());
  const std::vector<std::string>* list = nullptr;  // successive samples mostly share it
  std::vector<std::size_t> places;
  for (const Sample& sample : samples) {
    if (sample.names.get() != list) {
      list = sample.names.get();
      places = places_of(names, *list);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
      columns[i].push_back(places[i] < sample.values.size() ? sample.values[places[i]] : kNone);
    }
  }
  return columns;
}

}  // namespace elsie::server
