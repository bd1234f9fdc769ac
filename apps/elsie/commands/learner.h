// Finds a robot's coordinator and prepares it for training.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/declaration.h"
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

/// An option of the command line that replaces a parameter.
struct LearnerOption {
  std::string option;  // "--learning-rate"
  std::string parameter;
  elsie::ParameterValue value;
};

/// A coordinator that can be trained, on a robot that is equipped as in a run.
struct Learner {
  std::unique_ptr<const world::World> world;  // with the options
  std::optional<simulation::EquippedRobot> equipped;
  const neural::Trainable* network = nullptr;  // the robot's
  std::string plugin;
  std::string robot;
  std::string stream;  // path of its random stream in a run
};

/// Makes the coordinator at this place, with `options` instead of the world's parameters and
/// without the world's weights. Throws BadInput when there is none, it does not learn, or an option
/// is refused; world::WorldError when the world does not fit the robot.
Learner make_learner(const world::World& world, const plugin::Host& host, const LearnerPlace& place,
                     const std::vector<LearnerOption>& options);

}  // namespace elsie::program
