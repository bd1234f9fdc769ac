// A robot's coordinator with nothing around it, to be trained.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "elsie/api/coordinator.h"
#include "elsie/api/declaration.h"
#include "elsie/neural/trainable.h"
#include "elsie/plugin/host.h"
#include "elsie/world/description.h"

/// Which coordinator of a world is meant.
struct LearnerPlace {
  std::optional<std::string> robot;  // its id; may be left out where there is only one
  /// The way from the robot to a behaviour that holds others, by ids: "explore/avoid". Empty: the
  /// robot's own coordinator.
  std::string behavior;
};

/// A coordinator that can be trained, configured and equipped as it would be in a simulation.
struct Learner {
  elsie::plugin::Object<elsie::Coordinator> object;
  elsie::neural::Trainable* network = nullptr;  // the same object
  std::string plugin;
  std::string robot;
  std::string stream;  // the path in the world that names its random stream in a run
};

/// Makes the coordinator at this place, with `parameters` instead of what the world says. Throws
/// BadInput when there is none or it is of a kind that does not learn, and world::WorldError when
/// it refuses its parameters or does not fit the robot.
Learner make_learner(const elsie::world::World& world, const elsie::plugin::Host& host,
                     const LearnerPlace& place,
                     const std::map<std::string, elsie::ParameterValue>& parameters);
