// Sketches of plugins in Python.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

void bind_sketch(py::module_& module);

}  // namespace elsie::python
