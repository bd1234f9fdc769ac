// Finds a robot's coordinator and prepares it for training.
#pragma once

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

/// A coordinator that can be trained, on a robot that is equipped as in a run.
struct Learner {
  std::unique_ptr<const world::World> world;
  std::optional<simulation::EquippedRobot> equipped;
  const neural::Trainable* network = nullptr;  // the robot's
  std::string plugin;
  std::string robot;
  std::string path;  // also of its random stream in a run
};

/// The edits of the world that give the coordinator at this place these parameters, names with
/// their values, and take its weights away. Throws BadInput when there is none, or it does not
/// learn.
std::vector<std::string> learner_edits(
    const world::World& world, const plugin::Host& host, const LearnerPlace& place,
    const std::vector<std::pair<std::string, std::string>>& parameters);

/// Makes the coordinator at this place. Throws like learner_edits(), and world::WorldError when the
/// world does not fit the robot.
Learner make_learner(const world::World& world, const plugin::Host& host,
                     const LearnerPlace& place);

}  // namespace elsie::program
