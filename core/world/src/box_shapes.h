// What each shape of obstacles is in a world file.
#pragma once

#include <optional>
#include <string>

#include "elsie/shapes/box_shapes.h"
#include "elsie/world/describe.h"
#include "elsie/world/description.h"

namespace elsie::world {

struct BoxForm {
  const char* words;  // ": an upright cylinder", after what the obstacle does
  Describe<Box> (*with_size)(Describe<Box> box);
  Shape (*solid)(const Box& box);
  /// See problem_of(); null: its attributes are right.
  std::optional<std::string> (*problem)(const Box& box) = nullptr;
};

const BoxForm& form_of(BoxShape shape);

}  // namespace elsie::world
