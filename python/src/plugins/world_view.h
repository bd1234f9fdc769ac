// What measures and rules in Python see of the world, and how rules change it.
#pragma once

#include <pybind11/pybind11.h>

#include "elsie/api/measure.h"

#include "lent.h"
#include "made.h"

namespace elsie::python {

namespace py = pybind11;

/// `now` of a measure or a rule.
struct WorldNow : Made {
  LentTo<const Observation> observation = std::make_shared<Lent<const Observation>>();

  const Observation& operator*() const { return **observation; }
  const Observation* operator->() const { return &**observation; }
};

void bind_world_view(py::module_& module);
void bind_rules(py::module_& module);

}  // namespace elsie::python
