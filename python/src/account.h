// Who decided in a run, as arrays of numpy.
#pragma once

#include <memory>
#include <string>

#include <pybind11/numpy.h>

#include "elsie/traces/account_recorder.h"

#include "bindings.h"
#include "made.h"

namespace elsie::python {

/// Of a run that has ended. It needs no simulation any more.
class Account : public Made {
 public:
  explicit Account(std::shared_ptr<const traces::AccountRecorder> recorder)
      : recorder_(std::move(recorder)) {}

  /// (robot, path of the behaviour around it) of each coordinator; "": the robot's own.
  py::list coordinators() const;
  /// A row for each episode: from_s, to_s, decider ("": nobody, "*": several), share, weight,
  /// reason. Throws base::BadInput if there is no such coordinator.
  py::array episodes(const std::string& robot, const std::string& inside) const;
  /// A row for each behaviour of the robot, at any depth: its sums.
  py::array behaviors(const std::string& robot) const;

 private:
  std::shared_ptr<const traces::AccountRecorder> recorder_;
};

}  // namespace elsie::python
