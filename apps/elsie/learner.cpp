#include "learner.h"

#include <algorithm>
#include <deque>
#include <exception>
#include <stdexcept>
#include <utility>

#include "elsie/api/sensor.h"
#include "elsie/plugin/near_name.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/error.h"

#include "command.h"

namespace {

namespace world = elsie::world;
using elsie::PluginKind;

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

/// The one of these whose id is `id`.
template <class Thing>
const Thing& find(const std::vector<Thing>& things, const std::string& id, const std::string& what,
                  const std::string& where) {
  std::vector<std::string> ids;
  for (const Thing& thing : things) {
    if (thing.id == id) {
      return thing;
    }
    ids.push_back(thing.id);
  }
  throw BadInput("there is no " + what + " '" + id + "' " + where +
                 elsie::plugin::did_you_mean(id, ids) +
                 (ids.empty() ? "" : "; there are: " + list_of(ids)));
}

const world::Robot& robot_of(const world::World& world, const std::optional<std::string>& id) {
  if (id) {
    return find(world.robots, *id, "robot", "in this world");
  }
  if (world.robots.size() == 1) {
    return world.robots.front();
  }
  std::vector<std::string> ids;
  for (const world::Robot& robot : world.robots) {
    ids.push_back(robot.id);
  }
  throw BadInput(ids.empty() ? "there is no robot in this world"
                             : "there are several robots in this world; say which with --robot: " +
                                   list_of(ids));
}

/// Runs what plugins do while they are put together; what they throw is a fault of the world.
template <class Action>
auto blaming(const world::PluginUse& use, Action action) {
  try {
    return action();
  } catch (const std::exception& problem) {
    throw world::WorldError(
        {{use.location.file, use.location.line, "plugin '" + use.plugin + "': " + problem.what()}});
  }
}

template <class Kind>
elsie::plugin::Object<Kind> make(const elsie::plugin::Host& host, PluginKind kind,
                                 const world::PluginUse& use,
                                 const std::map<std::string, elsie::ParameterValue>& parameters) {
  return blaming(use, [&] {
    auto object = host.create<Kind>(kind, use.plugin);
    elsie::plugin::apply_parameters(
        *host.find(kind, use.plugin), *object, parameters,
        std::vector<elsie::ElementValue>(use.elements.begin(), use.elements.end()));
    return object;
  });
}

/// The readings that a robot will ever have, with values that mean nothing.
class Example {
 public:
  Example(const world::Robot& robot, const elsie::plugin::Host& host) {
    for (const world::SensorUse& use : robot.sensors) {
      sensors_.push_back(make<elsie::Sensor>(host, PluginKind::sensor, use, use.parameters));
      mountings_.push_back({{use.x.value_or(0.5 * robot.body.length), use.y.value_or(0.0),
                             use.z.value_or(robot.body.top())},
                            elsie::wrap_angle(elsie::radians(use.yaw_deg)),
                            elsie::radians(use.pitch_deg)});
    }
    for (const auto& sensor : sensors_) {
      const elsie::ReadingKind kind = sensor->kind();
      if (std::none_of(groups_.begin(), groups_.end(),
                       [&](const elsie::ReadingGroup& group) { return group.kind == kind; })) {
        add_group(kind, robot);
      }
    }
    self_.id = robot.id;
    self_.max_speed_m_s = robot.max_speed;
    self_.is_leader = robot.leader;
    team_.name = robot.team;
    data_.groups = groups_;
    data_.self = &self_;
    data_.team = &team_;
  }
  Example(const Example&) = delete;
  Example& operator=(const Example&) = delete;

  elsie::Perception perception() { return {data_, random_}; }

 private:
  void add_group(const elsie::ReadingKind& kind, const world::Robot& robot) {
    std::vector<elsie::SensedReading>& readings = readings_.emplace_back();
    for (std::size_t i = 0; i < sensors_.size(); ++i) {
      if (sensors_[i]->kind() == kind) {
        readings.push_back({sensors_[i]->reading(), &mountings_[i], robot.sensors[i].id});
      }
    }
    groups_.push_back({kind, readings});
  }

  std::vector<elsie::plugin::Object<elsie::Sensor>> sensors_;
  std::deque<elsie::Mounting> mountings_;
  std::deque<std::vector<elsie::SensedReading>> readings_;
  std::vector<elsie::ReadingGroup> groups_;
  elsie::OwnState self_;
  elsie::TeamState team_;
  elsie::Perception::Data data_;
  elsie::Random random_;
};

/// Behaviours that nobody may ask.
class Nobody final : public elsie::Member::Runner {
 public:
  const elsie::Response& run(elsie::Member& member) override { refuse(member); }
  void rate(elsie::Member& member, std::span<const elsie::MotorCommand>,
            std::span<double>) override {
    refuse(member);
  }
  elsie::CommandSets command_sets(elsie::Member& member) override { refuse(member); }

 private:
  [[noreturn]] static void refuse(const elsie::Member& member) {
    throw std::logic_error("the behaviour '" + std::string(member.name()) +
                           "' was asked before there was a run");
  }
};

std::string learners(const elsie::plugin::Host& host) {
  std::vector<std::string> names;
  for (const elsie::Declaration* declaration : host.all(PluginKind::coordinator)) {
    try {
      const auto object =
          host.create<elsie::Coordinator>(PluginKind::coordinator, declaration->name);
      if (dynamic_cast<const elsie::neural::Trainable*>(object.get())) {
        names.push_back(declaration->name);
      }
    } catch (const std::exception&) {  // a plugin that cannot be made does not learn, either
    }
  }
  return names.empty() ? "none was found that does" : "those that do: " + list_of(names);
}

}  // namespace

Learner make_learner(const world::World& world, const elsie::plugin::Host& host,
                     const LearnerPlace& place,
                     const std::map<std::string, elsie::ParameterValue>& parameters) {
  const world::Robot& robot = robot_of(world, place.robot);
  Learner learner;
  learner.robot = robot.id;
  learner.stream = "robot[" + robot.id + "]/";
  const world::Coordination* coordination = &robot;
  std::string owner = "robot '" + robot.id + "'";
  for (std::size_t at = 0; at < place.behavior.size();) {
    const std::size_t end = std::min(place.behavior.find('/', at), place.behavior.size());
    const std::string id = place.behavior.substr(at, end - at);
    at = end + 1;
    const auto& behavior = find(coordination->behaviors, id, "behaviour", "in " + owner);
    owner = "behaviour '" + id + "'";
    if (behavior.inside.empty()) {
      throw BadInput("the " + owner + " holds no other behaviours, and so has no coordinator");
    }
    coordination = &behavior.inside.front();
    learner.stream += "behavior[" + id + "]/";
  }
  learner.stream += "coordinator";
  if (!coordination->coordinator) {
    throw BadInput("the " + owner + " has no coordinator");
  }

  world::PluginUse use = *coordination->coordinator;
  learner.plugin = use.plugin;
  {
    const auto object = host.create<elsie::Coordinator>(PluginKind::coordinator, use.plugin);
    if (!dynamic_cast<const elsie::neural::Trainable*>(object.get())) {
      throw BadInput("the coordinator '" + use.plugin + "' of the " + owner + " does not learn; " +
                     learners(host));
    }
  }
  for (const auto& [name, value] : parameters) {
    use.parameters[name] = value;
  }
  learner.object = make<elsie::Coordinator>(host, PluginKind::coordinator, use, use.parameters);
  learner.network = dynamic_cast<elsie::neural::Trainable*>(learner.object.get());
  Nobody nobody;
  std::vector<elsie::Member> members;
  for (const world::BehaviorUse& behavior : coordination->behaviors) {
    members.emplace_back(behavior.id, behavior.priority, nobody);
  }
  Example example(robot, host);
  blaming(use, [&] {
    learner.object->equipped(members, example.perception());
    return 0;
  });
  return learner;
}
