// The errors of a training file or a weight file.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::neural {

using base::Problem;
using base::Problems;

/// All errors of a file.
class FileError : public base::FileError {
 public:
  using base::FileError::FileError;
};

}  // namespace elsie::neural
