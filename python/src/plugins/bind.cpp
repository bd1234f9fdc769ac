#include "actuator.h"
#include "bindings.h"
#include "coordinator.h"
#include "motion.h"
#include "perception.h"
#include "script.h"
#include "sensor.h"
#include "sketch.h"
#include "world_view.h"

namespace elsie::python {

void bind_plugins(py::module_& module) {
  bind_motion(module);
  bind_perception(module);
  bind_members(module);
  bind_sensors(module);
  bind_actuators(module);
  bind_world_view(module);
  bind_rules(module);
  bind_sketch(module);
  bind_scripts(module);
}

}  // namespace elsie::python
