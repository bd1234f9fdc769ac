#include "results.h"

#include <pybind11/stl.h>

namespace elsie::python {

py::dict dict_of(const simulation::RunResult& result) {
  py::dict of;
  of["outcome"] = to_string(result.outcome);
  of["reason"] = result.reason;
  of["seed"] = result.seed;
  of["time_s"] = result.simulated_s;
  of["wall_s"] = result.wall_s;
  of["steps"] = result.steps;
  of["state_hash"] = simulation::hash_text(result.state_hash);
  py::dict measures, units;
  for (const simulation::MeasuredValue& measured : result.measures) {
    measures[py::str(measured.name)] = measured.value;
    units[py::str(measured.name)] = measured.unit;
  }
  of["measures"] = measures;
  of["units"] = units;
  py::list robots, events, notes;
  for (const simulation::RobotResult& robot : result.robots) {
    robots.append(py::make_tuple(
        robot.id, robot.team, robot.distance_m, robot.collected, robot.energy, robot.collisions,
        py::make_tuple(robot.pose.x, robot.pose.y, robot.pose.heading_rad)));
  }
  for (const simulation::EventRecord& event : result.events) {
    events.append(py::make_tuple(event.time_s, event.robot, event.name(), event.detail()));
  }
  for (const simulation::Note& note : result.notes) {
    notes.append(py::make_tuple(note.robot, note.plugin, note.text));
  }
  of["robots"] = robots;
  of["events"] = events;
  of["notes"] = notes;
  return of;
}

}  // namespace elsie::python
