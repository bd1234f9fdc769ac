// What each shape of obstacles is in a world file.
#pragma once

#include <optional>
#include <string>

#include "elsie/shapes/obstacle_shapes.h"
#include "elsie/world/describe.h"
#include "elsie/world/description.h"

namespace elsie::world {

struct BoxForm {
  const char* words;  // ": an upright cylinder", after what the obstacle does
  Describe<Obstacle> (*with_size)(Describe<Obstacle> obstacle);
  Shape (*solid)(const Obstacle& obstacle);
  /// See problem_of(); null: its attributes are right.
  std::optional<std::string> (*problem)(const Obstacle& obstacle) = nullptr;
};

const BoxForm& form_of(ObstacleShape shape);

}  // namespace elsie::world
