// Finds a robot's coordinator that learns.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elsie/neural/trainable.h"
#include "elsie/plugin/host.h"
#include "elsie/simulation/equipped_robot.h"
#include "elsie/world/description.h"

namespace elsie::program {

/// Names a coordinator of a world.
struct LearnerPlace {
  std::optional<std::string> robot;  // its id; optional if there is only one robot
  /// The ids from the robot to a behaviour that holds others: "explore/avoid". Empty: the robot's
  /// own coordinator.
  std::string behavior;
};

struct FoundCoordinator {
  std::size_t robot = 0;                  // its index
  const world::PluginUse* use = nullptr;  // in the world
  std::string owner;                      // its name in messages
  std::string path;                       // also of its random stream in a run
};

/// Throws BadInput when there is none.
FoundCoordinator find_coordinator(const world::World& world, const LearnerPlace& place);

/// From what a coordinator learns: a file of samples (neural::Trainable), or rewards
/// (learning::RewardLearner).
enum class Lessons { samples, rewards };

/// Throws BadInput when it does not learn.
Lessons lessons_of(const FoundCoordinator& found, const plugin::Host& host);

/// The edits of the world that give the coordinator these parameters, names with their values, and
/// take away the file of what it has learned, which the parameter `learned` names.
std::vector<std::string> learner_edits(
    const FoundCoordinator& found, const std::string& learned,
    const std::vector<std::pair<std::string, std::string>>& parameters);

/// A coordinator whose network can be trained, on a robot that is equipped as in a run.
struct Learner {
  std::unique_ptr<const world::World> world;
  std::optional<simulation::EquippedRobot> equipped;
  const neural::Trainable* network = nullptr;  // the robot's
  std::string plugin;
  std::string robot;
  std::string path;
};

/// Makes the coordinator at this place. Throws BadInput, and world::WorldError when the world does
/// not fit the robot.
Learner make_learner(const world::World& world, const plugin::Host& host,
                     const LearnerPlace& place);

}  // namespace elsie::program
