// Memory that arrays of numpy show: filled by a simulation, seen by any number of arrays.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

#include "elsie/simulation/simulation.h"

#include "bindings.h"

namespace elsie::python {

/// Memory with a row for each robot, sensor or published number. Views of it are no copies; they
/// stay valid, and keep their last numbers, when the table and the simulation are gone.
class Table {
 public:
  using Fill = std::function<void(const simulation::Simulation& now, std::span<std::byte> memory)>;

  /// `dtype`: of a row, or of each of its numbers; `shape`: the rows, then the numbers of a row.
  Table(py::dtype dtype, std::vector<py::ssize_t> shape, Fill fill);

  void refresh(const simulation::Simulation& now) { fill_(now, *memory_); }
  /// Takes over what another table shows, in the same memory if it has the same form.
  void become(Table other);
  /// A view that cannot be written to.
  py::array view() const;

 private:
  py::dtype dtype_;
  std::vector<py::ssize_t> shape_;
  Fill fill_;
  std::shared_ptr<std::vector<std::byte>> memory_;
};

/// A table by the name of its property: "poses", "beliefs", "motions", "commands", "energies",
/// "distances", "collisions"; with a row for each robot.
Table table_of_robots(const simulation::Simulation& now, const std::string& name);
/// The poses of all obstacles; NaN for those that were collected. `name` has no meaning.
Table table_of_obstacles(const simulation::Simulation& now, const std::string& name);
/// A field of the world: rows from south to north, each from west to east, units/m2. Throws
/// base::BadInput if there is none of this name.
Table table_of_field(const simulation::Simulation& now, const std::string& name);
/// The readings of all sensors with this id, plugin or kind of reading. Throws base::BadInput if
/// there are none.
Table table_of_readings(const simulation::Simulation& now, const std::string& name);
/// The numbers that plugins publish under this name. Throws base::BadInput if there are none.
Table table_of_published(const simulation::Simulation& now, const std::string& name);

}  // namespace elsie::python
