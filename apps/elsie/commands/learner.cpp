#include "learner.h"

#include <algorithm>
#include <exception>
#include <utility>
#include <variant>

#include "elsie/api/coordinator.h"
#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/learning/reward_learner.h"

#include "command.h"

namespace elsie::program {

namespace {

using elsie::PluginKind;

/// The element of the list with this id.
template <class Things>
const auto& find(const Things& things, const std::string& id, const char* what,
                 const std::string& where) {
  std::vector<std::string> ids;
  for (const auto& thing : things) {
    if (thing.id == id) {
      return thing;
    }
    ids.push_back(thing.id);
  }
  throw BadInput(std::string("there is no ") + what + " '" + id + "' " + where +
                 base::did_you_mean(id, ids) +
                 (ids.empty() ? "" : "; there are: " + base::joined(ids)));
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
                                   base::joined(ids));
}

std::optional<Lessons> lessons_of(const elsie::Coordinator& object) {
  if (dynamic_cast<const neural::Trainable*>(&object)) return Lessons::samples;
  if (dynamic_cast<const learning::RewardLearner*>(&object)) return Lessons::rewards;
  return std::nullopt;
}

std::string learners(const plugin::Host& host) {
  std::vector<std::string> names;
  for (const elsie::Declaration* declaration : host.all(PluginKind::coordinator)) {
    try {
      const auto object =
          host.create<elsie::Coordinator>(PluginKind::coordinator, declaration->name);
      if (lessons_of(*object)) names.push_back(declaration->name);
    } catch (const std::exception&) {  // a plugin that cannot be made does not learn
    }
  }
  return names.empty() ? "none was found that does" : "those that do: " + base::joined(names);
}

}  // namespace

FoundCoordinator find_coordinator(const world::World& world, const LearnerPlace& place) {
  const world::Robot& robot = robot_of(world, place.robot);
  FoundCoordinator found{0, nullptr, "robot '" + robot.id + "'", "robot[" + robot.id + "]/"};
  while (world.robots[found.robot].id != robot.id) ++found.robot;
  const world::Coordination* coordination = &robot;
  for (std::size_t at = 0; at < place.behavior.size();) {
    const std::size_t end = std::min(place.behavior.find('/', at), place.behavior.size());
    const std::string id = place.behavior.substr(at, end - at);
    at = end + 1;
    const std::string where = "in " + found.owner;
    const world::BehaviorUse& holder = find(coordination->behaviors, id, "behaviour", where);
    found.owner = "behaviour '" + id + "'";
    if (holder.inside.empty()) {
      throw BadInput("the " + found.owner +
                     " holds no other behaviours, and so has no coordinator");
    }
    coordination = &holder.inside.front();
    found.path += "behavior[" + id + "]/";
  }
  found.path += "coordinator";
  if (!coordination->coordinator) {
    throw BadInput("the " + found.owner + " has no coordinator");
  }
  found.use = &*coordination->coordinator;
  return found;
}

Lessons lessons_of(const FoundCoordinator& found, const plugin::Host& host) {
  const auto object = host.create<elsie::Coordinator>(PluginKind::coordinator, found.use->plugin);
  const auto lessons = lessons_of(*object);
  if (!lessons) {
    throw BadInput("the coordinator '" + found.use->plugin + "' of the " + found.owner +
                   " does not learn; " + learners(host));
  }
  return *lessons;
}

std::vector<std::string> learner_edits(
    const FoundCoordinator& found, const std::string& learned,
    const std::vector<std::pair<std::string, std::string>>& parameters) {
  std::vector<std::string> edits;
  const auto file = found.use->parameters.find(learned);
  if (file != found.use->parameters.end() && std::get<std::string>(file->second) != "") {
    edits.push_back(found.path + "/@" + learned + "/@remove=true");
  }
  for (const auto& [name, value] : parameters) {
    edits.push_back(found.path + "/@" + name + "=" + value);
  }
  return edits;
}

Learner make_learner(const world::World& world, const plugin::Host& host,
                     const LearnerPlace& place) {
  Learner learner;
  learner.world = std::make_unique<const world::World>(world);
  const FoundCoordinator found = find_coordinator(*learner.world, place);
  learner.plugin = found.use->plugin;
  learner.robot = learner.world->robots[found.robot].id;
  learner.path = found.path;
  learner.equipped.emplace(*learner.world, found.robot, host);
  learner.network = dynamic_cast<const neural::Trainable*>(&learner.equipped->object(*found.use));
  return learner;
}

}  // namespace elsie::program
