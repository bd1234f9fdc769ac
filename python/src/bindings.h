// The parts of the module `_elsie`, one function for each file that binds some.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

namespace py = pybind11;

/// Errors of Elsie become exceptions of elsie/errors.py.
void bind_errors(py::module_& module);
void bind_worlds(py::module_& module);
void bind_simulations(py::module_& module);
void bind_pictures(py::module_& module);
void bind_inference(py::module_& module);
/// elsie._elsie.Worlds, of which environments for learning are made.
void bind_environments(py::module_& module);
/// Plugins in Python (plugins/): what a script sees of Elsie, and how the core loads scripts.
void bind_plugins(py::module_& module);

}  // namespace elsie::python
