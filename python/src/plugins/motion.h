// Motions and answers of behaviours in Python.
#pragma once

#include <pybind11/pybind11.h>

#include "elsie/api/behavior.h"

namespace elsie::python {

namespace py = pybind11;

/// A Motion that a script gives; null: it gave something else.
const Motion* as_motion(py::handle given);

/// What respond() answered. Throws base::Error with a sentence when that is no answer.
/// `may_be_none`: the behaviour only acts.
Response as_response(py::handle given, bool may_be_none);

void bind_motion(py::module_& module);

}  // namespace elsie::python
