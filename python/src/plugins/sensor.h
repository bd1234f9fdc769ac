// Sensors in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

/// What a sensor sees of the world.
void bind_sensors(py::module_& module);

}  // namespace elsie::python
