#include "learner.h"

#include <algorithm>
#include <exception>
#include <map>
#include <utility>

#include "elsie/api/coordinator.h"
#include "elsie/base/near_name.h"
#include "elsie/world/error.h"

#include "command.h"

namespace elsie::program {

namespace {

using elsie::PluginKind;

std::string list_of(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

/// The element of the list with this id.
template <class Things>
auto& find(Things& things, const std::string& id, const std::string& what,
           const std::string& where) {
  std::vector<std::string> ids;
  for (auto& thing : things) {
    if (thing.id == id) {
      return thing;
    }
    ids.push_back(thing.id);
  }
  throw BadInput("there is no " + what + " '" + id + "' " + where + base::did_you_mean(id, ids) +
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

/// The coordinator at this place of the robot, which the caller may change. Sets `owner` to its
/// name in messages and `stream` to the path of its random stream.
world::PluginUse& coordinator_at(world::Robot& robot, const std::string& behavior,
                                 std::string& owner, std::string& stream) {
  owner = "robot '" + robot.id + "'";
  stream = "robot[" + robot.id + "]/";
  world::Coordination* coordination = &robot;
  for (std::size_t at = 0; at < behavior.size();) {
    const std::size_t end = std::min(behavior.find('/', at), behavior.size());
    const std::string id = behavior.substr(at, end - at);
    at = end + 1;
    world::BehaviorUse& holder = find(coordination->behaviors, id, "behaviour", "in " + owner);
    owner = "behaviour '" + id + "'";
    if (holder.inside.empty()) {
      throw BadInput("the " + owner + " holds no other behaviours, and so has no coordinator");
    }
    coordination = &holder.inside.front();
    stream += "behavior[" + id + "]/";
  }
  stream += "coordinator";
  if (!coordination->coordinator) {
    throw BadInput("the " + owner + " has no coordinator");
  }
  return *coordination->coordinator;
}

std::string learners(const plugin::Host& host) {
  std::vector<std::string> names;
  for (const elsie::Declaration* declaration : host.all(PluginKind::coordinator)) {
    try {
      const auto object =
          host.create<elsie::Coordinator>(PluginKind::coordinator, declaration->name);
      if (dynamic_cast<const neural::Trainable*>(object.get())) {
        names.push_back(declaration->name);
      }
    } catch (const std::exception&) {  // a plugin that cannot be made does not learn
    }
  }
  return names.empty() ? "none was found that does" : "those that do: " + list_of(names);
}

/// A plugin's message without the plugin's name at its beginning.
std::string without_name(const std::string& message, const std::string& plugin) {
  for (const std::string kind : {"coordinator '", "plugin '"}) {
    const std::string name = kind + plugin + "': ";
    if (message.starts_with(name)) {
      return message.substr(name.size());
    }
  }
  return message;
}

/// Makes learners; it reads the world once for each set of options.
class Maker {
 public:
  Maker(const world::World& world, const plugin::Host& host, const LearnerPlace& place)
      : host_(host), place_(place), world_(world) {
    const std::string& id = robot_of(world, place.robot).id;
    while (world.robots[index_].id != id) ++index_;
    use_ = &coordinator_at(world_.robots[index_], place.behavior, owner_, stream_);
    described_ = use_->parameters;
    const auto object = host.create<elsie::Coordinator>(PluginKind::coordinator, use_->plugin);
    if (!dynamic_cast<const neural::Trainable*>(object.get())) {
      throw BadInput("the coordinator '" + use_->plugin + "' of the " + owner_ +
                     " does not learn; " + learners(host));
    }
  }

  Learner make(const std::vector<LearnerOption>& options) {
    try {
      return attempt(options);
    } catch (const world::WorldError& error) {
      blame_options(error, options);
      throw;
    }
  }

 private:
  Learner attempt(const std::vector<LearnerOption>& options) {
    use_->parameters = described_;
    use_->parameters["weights"] = std::string();  // new weights are made in any case
    for (const LearnerOption& option : options) {
      use_->parameters[option.parameter] = option.value;
    }
    Learner learner;
    auto world = std::make_unique<world::World>(world_);
    std::string owner;
    const world::PluginUse& use =
        coordinator_at(world->robots[index_], place_.behavior, owner, learner.stream);
    learner.plugin = use.plugin;
    learner.robot = world->robots[index_].id;
    learner.world = std::move(world);
    learner.equipped.emplace(*learner.world, index_, host_);
    learner.network = dynamic_cast<const neural::Trainable*>(&learner.equipped->object(use));
    return learner;
  }

  /// The problems with these options; empty when the robot can be made.
  std::vector<base::Problem> problems_with(const std::vector<LearnerOption>& options) {
    try {
      attempt(options);
      return {};
    } catch (const world::WorldError& error) {
      return error.problems();
    }
  }

  /// Throws BadInput when an option is at fault: when the problem disappears without it.
  void blame_options(const world::WorldError& error, const std::vector<LearnerOption>& options) {
    const auto told_by = [](const base::Problem& problem,
                            const std::vector<base::Problem>& problems) {
      return std::find(problems.begin(), problems.end(), problem) != problems.end();
    };
    const std::vector<base::Problem> without_all = problems_with({});
    std::string text;
    for (const base::Problem& problem : error.problems()) {
      if (told_by(problem, without_all)) {
        continue;  // a problem of the world itself
      }
      std::vector<std::string> all, guilty;
      for (std::size_t i = 0; i < options.size(); ++i) {
        std::vector<LearnerOption> others = options;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        all.push_back(options[i].option);
        if (!told_by(problem, problems_with(others))) {
          guilty.push_back(options[i].option);
        }
      }
      text += (text.empty() ? "" : "\n") + list_of(guilty.empty() ? all : guilty) + ": " +
              without_name(problem.message, use_->plugin);
    }
    if (!text.empty()) {
      throw BadInput(text);
    }
  }

  const plugin::Host& host_;
  const LearnerPlace& place_;
  world::World world_;
  std::size_t index_ = 0;
  world::PluginUse* use_ = nullptr;  // the coordinator, in world_
  std::map<std::string, elsie::ParameterValue> described_;
  std::string owner_, stream_;
};

}  // namespace

Learner make_learner(const world::World& world, const plugin::Host& host, const LearnerPlace& place,
                     const std::vector<LearnerOption>& options) {
  return Maker(world, host, place).make(options);
}

}  // namespace elsie::program
