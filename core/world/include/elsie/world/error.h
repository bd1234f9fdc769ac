// What is wrong with a world file.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::world {

using base::Location;
using base::Problem;
using base::Problems;

/// All the mistakes of a world and of the templates that it includes.
class WorldError : public base::FileError {
 public:
  using base::FileError::FileError;
};

}  // namespace elsie::world
