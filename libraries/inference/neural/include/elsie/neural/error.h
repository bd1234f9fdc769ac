// What is wrong with a training file or a weight file.
#pragma once

#include "elsie/base/problems.h"

namespace elsie::neural {

using base::Problem;
using base::Problems;

/// Everything that is wrong with a file.
class FileError : public base::FileError {
 public:
  using base::FileError::FileError;
};

}  // namespace elsie::neural
