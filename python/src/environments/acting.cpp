#include "acting.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/world/attributes.h"

namespace elsie::python {
namespace {

constexpr const char* kCommanded = "commanded";
constexpr const char* kMotion[] = {"forward", "lateral", "turn"};

bool is_path(const Named& named) { return named.name.find('@') != std::string::npos; }
bool is_of_own(const Named& named) { return is_path(named) || named.name == "priorities"; }
bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);  // 0 is not -0
}

/// The numbers of commands that a name stands for, if it is one of an actuator: itself, or all that
/// are no arrays.
std::string commands_of(const world::Robot& robot, const plugin::Host& host,
                        const std::string& name) {
  const std::size_t point = name.find('.');
  const std::string id = name.substr(0, point);
  const auto use = std::find_if(robot.actuators.begin(), robot.actuators.end(),
                                [&](const auto& each) { return each.id == id; });
  if (use == robot.actuators.end()) return "";
  if (point != std::string::npos) return " " + name;
  std::string all;
  const Declaration* const actuator = host.find(PluginKind::actuator, use->plugin);
  for (const FieldDeclaration& field : actuator->takes.front().fields) {
    if (field.is_single) all += " " + id + "." + field.name;
  }
  return all;
}

/// The numbers of a robot's actuators: "gripper.closed".
template <class Visit>
void for_each_command(const simulation::Simulation& simulation, std::size_t robot,
                      const Visit& visit) {
  for (std::size_t i = 0; i < simulation.actuators(robot); ++i) {
    const std::string id(simulation.actuator(robot, i).id);
    simulation.visit_command(robot, i, [&](const ReadingField& field) {
      for (std::size_t k = 0; field.is_stored && field.is_number() && k < field.count; ++k) {
        visit(id, id + "." + field.column(k), field);
      }
    });
  }
}

}  // namespace

void prepare(world::World& world, const plugin::Host& host, std::size_t robot,
             const std::vector<Named>& names) {
  const auto own = std::find_if(names.begin(), names.end(), is_of_own);
  const auto other = std::find_if_not(names.begin(), names.end(), is_of_own);
  if (own != names.end() && other != names.end()) {
    throw base::BadInput("act: '" + own->name + "' needs the robot's own behaviours, and '" +
                         other->name + "' replaces them; expected one or the other");
  }
  if (other == names.end()) return;
  world::Robot& changed = world.robots[robot];
  changed.behaviors.clear();
  world::BehaviorUse& use = changed.behaviors.emplace_back();
  use.plugin = use.id = kCommanded;
  std::string commands;
  for (const Named& named : names) commands += commands_of(changed, host, named.name);
  if (!commands.empty()) use.parameters["commands"] = commands.substr(1);
  world::PluginUse& coordinator = changed.coordinator.emplace();
  coordinator.plugin = coordinator.id = "arbiter_suppression";
}

Acting::Acting(simulation::Simulation& simulation, const plugin::Host& host, std::size_t robot,
               const std::vector<Named>& names, bool by_edits)
    : robot_(robot), by_edits_(by_edits) {
  behaviors_ = "robot[" + simulation.robot(robot).description->id + "]/behavior[";
  for (const Named& named : names) {
    const bool is_known = is_path(named) ? add_parameters(simulation, host, named)
                                         : add_motion(simulation, named) ||
                                               add_priorities(simulation, named) ||
                                               add_commands(simulation, named);
    if (!is_known) refuse(simulation, named);
  }
  take(std::vector<Bounded>(numbers_));
  find_commanded(simulation, host);
}

void Acting::add(Number number, Bounded bounds, const Named& named) {
  bounds.take_bounds(named);
  if (!(bounds.low < bounds.high) || !std::isfinite(bounds.high - bounds.low)) {
    throw base::BadInput("act: the bounds of '" + bounds.name +
                         "' are not known, or no interval; expected (name, least, greatest)");
  }
  actions_.push_back(std::move(number));
  numbers_.push_back(std::move(bounds));
}

void Acting::take(const std::vector<Bounded>& numbers) {
  numbers_ = numbers;
  for (std::size_t i = 0; i < numbers_.size(); ++i) {
    actions_[i].middle = 0.5 * (numbers_[i].low + numbers_[i].high);
    actions_[i].half = 0.5 * (numbers_[i].high - numbers_[i].low);
  }
}

double Acting::Number::value(float action) const {
  if (is_switch) return action > 0.0f ? 1.0 : 0.0;
  return middle + half * static_cast<double>(std::clamp(action, -1.0f, 1.0f));
}

bool Acting::add_motion(const simulation::Simulation& simulation, const Named& named) {
  const OwnState& state = *simulation.robot(robot_).state;
  const double fastest = state.max_speed_m_s;
  const double most[] = {fastest, fastest, fastest / state.wheels.half_axle};
  const bool has[] = {state.channels.forward, state.channels.lateral, state.channels.turn};
  const std::size_t before = actions_.size();
  for (std::size_t i = 0; i < std::size(kMotion); ++i) {
    const std::string name = std::string("motion.") + kMotion[i];
    if (!has[i] || (named.name != "motion" && named.name != name)) continue;
    add({Kind::motion, i, behaviors_ + kCommanded + "]/@" + kMotion[i]}, {name, -most[i], most[i]},
        named);
  }
  return actions_.size() > before;
}

/// One number of an actuator's command, or all: "gripper.closed", "gripper".
bool Acting::add_commands(const simulation::Simulation& simulation, const Named& named) {
  const std::size_t before = actions_.size();
  for_each_command(simulation, robot_,
                   [&](const std::string& id, const std::string& name, const ReadingField& field) {
                     if (named.name != name && (named.name != id || field.is_array)) return;
                     const bool is_switch = field.type == FieldType::boolean;
                     Bounded bounds{name, is_switch ? 0.0 : -1.0, 1.0};
                     if (field.type == FieldType::uint8) bounds = {name, 0.0, 255.0};
                     add({.kind = Kind::command, .index = commands_++, .is_switch = is_switch},
                         bounds, named);
                   });
  return actions_.size() > before;
}

/// The priorities of the behaviours that the robot's own coordinator coordinates.
bool Acting::add_priorities(const simulation::Simulation& simulation, const Named& named) {
  if (named.name != "priorities") return false;
  double most = 1.0;
  const simulation::RobotView view = simulation.robot(robot_);
  for (const world::BehaviorUse& use : view.description->behaviors) {
    most = std::max(most, use.priority);
  }
  for (std::size_t i = 0; i < view.trace.size(); ++i) {
    const simulation::TracedMember& member = view.trace[i];
    if (member.depth > 0) continue;
    const std::string path = "behavior[" + member.path + "]/@priority";
    add({Kind::priority, i, "robot[" + view.description->id + "]/" + path}, {path, 0.0, most},
        named);
  }
  return true;
}

/// Live parameters and priorities by their paths below the robot: "behavior[avoid]/@priority".
bool Acting::add_parameters(const simulation::Simulation& simulation, const plugin::Host& host,
                            const Named& named) {
  const simulation::RobotView view = simulation.robot(robot_);
  const std::string path = "robot[" + view.description->id + "]/" + named.name;
  const world::Attributes attributes(simulation.world(), host);
  std::vector<world::AttributeTarget> targets;
  try {
    targets = attributes.find(path);
  } catch (const std::invalid_argument& error) {
    throw base::BadInput("act: '" + named.name + "': " + error.what());
  }
  for (const world::AttributeTarget& target : targets) {
    const world::Field& field = target.field;
    if (!field.is_live() || field.type != ParameterType::real) {
      throw base::BadInput("act: '" + target.path + "' is no number that may change during a run");
    }
    Number number{Kind::parameter, 0, target.path};
    Bounded bounds{named.name, std::max(field.facts.min, field.facts.above), field.facts.max};
    if (target.attribute && field.name == "priority") {
      bounds.low = 0.0;
      bounds.high = 1.0;
      // Its place in the trace: the ids in the path.
      std::string ids;
      for (std::size_t at = 0; (at = target.path.find("behavior[", at)) != std::string::npos;) {
        at += 9;
        ids += (ids.empty() ? "" : "/") + target.path.substr(at, target.path.find(']', at) - at);
      }
      for (std::size_t i = 0; i < view.trace.size(); ++i) {
        if (view.trace[i].path == ids) {
          number.kind = Kind::priority;
          number.index = i;
        }
      }
    }
    has_parameters_ = has_parameters_ || number.kind == Kind::parameter;
    add(std::move(number), bounds, named);
  }
  return true;
}

/// The object that the actions set, and the parameters of its declaration.
void Acting::find_commanded(simulation::Simulation& simulation, const plugin::Host& host) {
  const bool needs_it = std::any_of(actions_.begin(), actions_.end(), [](const Number& number) {
    return number.kind == Kind::motion || number.kind == Kind::command;
  });
  if (!needs_it) return;
  const auto& behaviors = simulation.world().robots[robot_].behaviors;
  const Declaration* const declared = host.find(PluginKind::behavior, kCommanded);
  if (!declared || behaviors.empty()) {
    throw base::BadInput(host.explain_missing(PluginKind::behavior, kCommanded));
  }
  commanded_ = &simulation.object(robot_, behaviors.front());
  const auto parameter = [&](const char* name) {
    return &*std::find_if(declared->parameters.begin(), declared->parameters.end(),
                          [&](const auto& each) { return each.name == name; });
  };
  for (const char* name : kMotion) motion_.push_back(parameter(name));
  values_ = parameter("values");
}

void Acting::refuse(const simulation::Simulation& simulation, const Named& named) const {
  std::vector<std::string> known{"motion", "priorities"};
  for_each_command(simulation, robot_,
                   [&](const std::string& id, const std::string& name, const ReadingField&) {
                     if (std::find(known.begin(), known.end(), id) == known.end())
                       known.push_back(id);
                     known.push_back(name);
                   });
  const std::string near = base::near_or_all(named.name, known, "it has");
  throw base::BadInput("act: robot '" + simulation.robot(robot_).description->id +
                       "' has nothing that is named '" + named.name + "'" + near +
                       (near.ends_with("?") ? ""
                                            : "; live parameters are named by their paths, such "
                                              "as 'behavior[avoid]/@priority'"));
}

void Acting::apply(simulation::Simulation& simulation, const float* actions) const {
  if (by_edits_ || has_parameters_) {
    std::vector<double> before;
    std::vector<simulation::Edit> edits;
    add_edits(actions, before, edits);
    simulation.edit(edits);
    return;
  }
  std::vector<double> values(commands_);
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Number& number = actions_[i];
    const double value = number.value(actions[i]);
    if (number.kind == Kind::motion) {
      motion_[number.index]->set(*commanded_, value);
    } else if (number.kind == Kind::command) {
      values[number.index] = value;
    } else {
      simulation.set_priority(robot_, number.index, value);
    }
  }
  if (!commanded_) return;
  if (commands_ > 0) values_->set(*commanded_, std::move(values));
  commanded_->configured();
}

void Acting::forget() const {
  if (!commanded_) return;
  for (const ParameterDeclaration* parameter : motion_) {
    parameter->set(*commanded_, parameter->default_value);
  }
  values_->set(*commanded_, values_->default_value);
  commanded_->configured();
}

void Acting::add_edits(const float* actions, std::vector<double>& before,
                       std::vector<simulation::Edit>& edits) const {
  const bool is_first = before.empty();
  before.resize(actions_.size());
  std::vector<double> values(commands_);
  bool has_new_values = false;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    const Number& number = actions_[i];
    const double value = number.value(actions[i]);
    const bool is_new = is_first || !is_same(before[i], value);
    before[i] = value;
    if (number.kind == Kind::command) {
      values[number.index] = value;
      has_new_values = has_new_values || is_new;
    } else if (is_new) {
      edits.push_back({number.path, base::number_text(value)});
    }
  }
  if (!has_new_values) return;
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + base::number_text(value);
  edits.push_back({behaviors_ + kCommanded + "]/@values", text});
}

}  // namespace elsie::python
