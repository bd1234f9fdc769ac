#include "tables.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"

namespace elsie::python {
namespace {

/// A table with `width` numbers for each robot; 0: a number for each.
template <class Number, class Put>
Table of_robots(const simulation::Simulation& now, py::ssize_t width, Put put) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(now.robots())};
  if (width > 0) shape.push_back(width);
  const py::ssize_t stride = width > 0 ? width : 1;
  return {py::dtype::of<Number>(), std::move(shape),
          [put, stride, robots = now.robots()](const simulation::Simulation& then,
                                               std::span<std::byte> memory) {
            auto* at = reinterpret_cast<Number*>(memory.data());
            for (std::size_t i = 0; i < std::min(robots, then.robots()); ++i, at += stride) {
              put(then.robot(i), at);
            }
          }};
}

using simulation::RobotView;

void put_motion(const Motion& motion, double* at) {
  at[0] = motion.forward;
  at[1] = motion.lateral;
  at[2] = motion.turn;
}
void put_pose(const Pose& pose, double* at) {
  at[0] = pose.x;
  at[1] = pose.y;
  at[2] = pose.heading_rad;
}

}  // namespace

Table::Table(py::dtype dtype, std::vector<py::ssize_t> shape, Fill fill)
    : dtype_(std::move(dtype)), shape_(std::move(shape)), fill_(std::move(fill)) {
  auto bytes = static_cast<std::size_t>(dtype_.itemsize());
  for (const py::ssize_t size : shape_) bytes *= static_cast<std::size_t>(size);
  memory_ = std::make_shared<std::vector<std::byte>>(bytes);
}

void Table::become(Table other) {
  if (shape_ != other.shape_ || !dtype_.equal(other.dtype_)) {
    *this = std::move(other);
  } else {
    fill_ = std::move(other.fill_);
  }
}

py::array Table::view() const {
  using Memory = std::shared_ptr<std::vector<std::byte>>;
  const py::capsule owner(new Memory(memory_),
                          [](void* memory) { delete static_cast<Memory*>(memory); });
  py::array array(dtype_, shape_, memory_->data(), owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

Table table_of_robots(const simulation::Simulation& now, const std::string& name) {
  constexpr py::ssize_t kOfMotion = 3;
  if (name == "poses") {
    return of_robots<double>(now, kOfMotion,
                             [](const RobotView& robot, double* at) { put_pose(robot.pose, at); });
  }
  if (name == "beliefs") {
    return of_robots<double>(now, kOfMotion, [](const RobotView& robot, double* at) {
      put_pose(robot.state->pose, at);
    });
  }
  if (name == "motions") {
    return of_robots<double>(
        now, kOfMotion, [](const RobotView& robot, double* at) { put_motion(robot.moving, at); });
  }
  if (name == "commands") {
    return of_robots<double>(
        now, kOfMotion, [](const RobotView& robot, double* at) { put_motion(robot.command, at); });
  }
  if (name == "energies") {
    return of_robots<double>(now, 0,
                             [](const RobotView& robot, double* at) { *at = robot.state->energy; });
  }
  if (name == "distances") {
    return of_robots<double>(now, 0,
                             [](const RobotView& robot, double* at) { *at = robot.distance_m; });
  }
  if (name == "collisions") {
    return of_robots<std::int64_t>(
        now, 0, [](const RobotView& robot, std::int64_t* at) { *at = robot.collisions; });
  }
  throw base::BadInput("there is no array '" + name + "'");
}

Table table_of_obstacles(const simulation::Simulation& now, const std::string&) {
  const std::size_t count = now.world().obstacles.size();
  constexpr py::ssize_t kOfPose = 3;
  return {py::dtype::of<double>(),
          {static_cast<py::ssize_t>(count), kOfPose},
          [count](const simulation::Simulation& then, std::span<std::byte> memory) {
            auto* at = reinterpret_cast<double*>(memory.data());
            const double none = std::numeric_limits<double>::quiet_NaN();
            for (std::size_t i = 0; i < std::min(count, then.world().obstacles.size()); ++i) {
              put_pose(then.obstacle(i).value_or(Pose{none, none, none}), at);
              at += kOfPose;
            }
          }};
}

Table table_of_field(const simulation::Simulation& now, const std::string& name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < now.fields(); ++i) {
    const simulation::FieldView field = now.field(i);
    names.push_back(field.description->id);
    if (names.back() != name) continue;
    return {
        py::dtype::of<double>(),
        {static_cast<py::ssize_t>(field.cells.rows), static_cast<py::ssize_t>(field.cells.columns)},
        [i](const simulation::Simulation& then, std::span<std::byte> memory) {
          if (i >= then.fields()) return;
          const simulation::FieldView view = then.field(i);
          auto* at = reinterpret_cast<double*>(memory.data());
          const std::size_t count = std::min(view.grid.size(), memory.size() / sizeof *at);
          for (std::size_t k = 0; k < count; ++k) at[k] = view.scale * view.grid[k];
        }};
  }
  throw base::BadInput("the world has no field '" + name + "'" +
                       base::near_or_all(name, names, "there are"));
}

}  // namespace elsie::python
