// Coordinators in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

/// What a coordinator sees of its behaviours.
void bind_members(py::module_& module);

}  // namespace elsie::python
