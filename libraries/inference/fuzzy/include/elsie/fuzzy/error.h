// The errors of a fuzzy model file.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::fuzzy {

using base::Problem;

/// Thrown by read_fcl() and parse_fcl() with all errors of the file.
class FclError : public base::FileError {
 public:
  using base::FileError::FileError;
};

}  // namespace elsie::fuzzy
