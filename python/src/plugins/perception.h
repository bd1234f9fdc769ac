// `now`, what a behaviour or a coordinator in Python perceives.
#pragma once

#include <vector>

#include <pybind11/pybind11.h>

#include "elsie/api/perception.h"

#include "lent.h"
#include "made.h"
#include "reading_arrays.h"

namespace elsie::python {

namespace py = pybind11;

using LentRandom = LentTo<Random>;

/// `now`. One for each object of a plugin.
class Now : public Made {
 public:
  Now();

  /// What a call lends.
  class Call {
   public:
    Call(Now& now, const Perception& perception)
        : perception_(*now.perception_, perception), random_(*now.random_, perception.random()) {}

   private:
    Lending<const Perception> perception_;
    Lending<Random> random_;
  };

  const Perception& perception() const { return **perception_; }
  const LentPerception& lent() const { return perception_; }
  const LentRandom& random() const { return random_; }
  /// The dict of ReadingArrays, by kind.
  py::object readings();

 private:
  LentPerception perception_;
  LentRandom random_;
  py::object readings_;  // the dict, which the script may change
  struct Made {
    py::object object;
    ReadingArrays* arrays;
  };
  std::vector<Made> made_;  // in the order of the groups
};

void bind_perception(py::module_& module);

}  // namespace elsie::python
