// Scripts with plugins.
#pragma once

#include <pybind11/pybind11.h>

namespace elsie::python {

/// The capsule `load_script` for elsie/python.so.
void bind_scripts(pybind11::module_& module);

}  // namespace elsie::python
