// The error of world files.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::world {

using base::Location;
using base::Problem;
using base::Problems;

/// All mistakes of a world and its templates.
class WorldError : public base::FileError {
 public:
  using base::FileError::FileError;
};

}  // namespace elsie::world
