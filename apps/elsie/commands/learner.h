// A robot's coordinator, to be trained.
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

/// Which coordinator of a world is meant.
struct LearnerPlace {
  std::optional<std::string> robot;  // its id; may be left out where there is only one
  /// The way from the robot to a behaviour that holds others, by ids: "explore/avoid". Empty: the
  /// robot's own coordinator.
  std::string behavior;
};

/// An option of the command line that takes the place of a parameter.
struct LearnerOption {
  std::string option;  // "--learning-rate"
  std::string parameter;
  elsie::ParameterValue value;
};

/// A coordinator that can be trained: one of a robot that is equipped as it would be in a run.
struct Learner {
  std::unique_ptr<const world::World> world;  // with the options in it
  std::optional<simulation::EquippedRobot> equipped;
  const neural::Trainable* network = nullptr;  // the robot's
  std::string plugin;
  std::string robot;
  std::string stream;  // the path in the world that names its random stream in a run
};

/// Makes the coordinator at this place, with `options` instead of what the world says, and without
/// the weights that the world gives it. Throws BadInput when there is none, it is of a kind that
/// does not learn, or one of the options is refused; and world::WorldError when the world does not
/// fit the robot.
Learner make_learner(const world::World& world, const plugin::Host& host, const LearnerPlace& place,
                     const std::vector<LearnerOption>& options);

}  // namespace elsie::program
