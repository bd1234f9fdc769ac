// Results of runs as objects of Python.
#pragma once

#include "elsie/simulation/run_result.h"

#include "bindings.h"

namespace elsie::python {

/// The arguments of elsie.Result.
py::dict dict_of(const simulation::RunResult& result);

}  // namespace elsie::python
