// Actuators in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

/// What an actuator can do.
void bind_actuators(py::module_& module);

}  // namespace elsie::python
