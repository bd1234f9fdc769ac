#include "world_view.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "elsie/base/near_name.h"

namespace elsie::python {
namespace {

/// A robot of `now`, by its index.
struct RobotView {
  LentTo<const Observation> observation;
  std::size_t index;

  const ObservedRobot& operator*() const {
    const auto& robots = (*observation)->robots;
    if (index >= robots.size()) {
      throw std::runtime_error("this robot is gone; take robots from `now` in each call");
    }
    return robots[index];
  }
};

template <class Get>
auto of_robot(Get get) {
  return [get](const RobotView& robot) { return get(*robot); };
}

py::dict numbers_of(std::span<const ObservedNumber> names, const ObservedNumbers* numbers) {
  py::dict all;
  if (!numbers) return all;
  const auto values = numbers->now();
  for (std::size_t i = 0; i < names.size(); ++i) all[py::str(names[i].name)] = values[i];
  return all;
}

py::object named(const char* type) { return py::module_::import("elsie.plugins").attr(type); }

/// An array with a number, or a row of numbers, for each robot.
template <class Get>
py::array_t<double> of_all(const Observation& now, Get get) {
  py::array_t<double> numbers(static_cast<py::ssize_t>(now.robots.size()));
  double* to = numbers.mutable_data();
  for (const ObservedRobot& robot : now.robots) *to++ = get(robot);
  return numbers;
}

py::array_t<double> poses(const Observation& now) {
  py::array_t<double> all({now.robots.size(), std::size_t{3}});
  double* to = all.mutable_data();
  for (const ObservedRobot& robot : now.robots) {
    *to++ = robot.pose.x, *to++ = robot.pose.y, *to++ = robot.pose.heading_rad;
  }
  return all;
}

py::list obstacles(const Observation& now) {
  constexpr const char* kKinds[] = {"fixed", "dynamic", "moving", "resource"};
  py::list all;
  for (const ObservedObstacle& each : now.obstacles) {
    all.append(named("Obstacle")(each.id, kKinds[static_cast<std::size_t>(each.kind)], each.team,
                                 each.pose));
  }
  return all;
}

py::array_t<double> field(const Observation& now, const std::string& id) {
  std::vector<std::string> known;
  for (const ObservedField& each : now.fields) {
    if (each.id != id) {
      known.emplace_back(each.id);
      continue;
    }
    py::array_t<double> cells({each.cells.empty() ? 0 : each.rows, each.columns});
    std::transform(each.cells.begin(), each.cells.end(), cells.mutable_data(),
                   [&](double cell) { return cell * each.scale; });
    return cells;
  }
  throw py::key_error("the world has no field '" + id + "'" +
                      base::near_or_all(id, known, "there are"));
}

void bind_robots(py::module_& module) {
  py::class_<RobotView>(module, "RobotView", "A robot as measures and rules see it.")
      .def_property_readonly("id", of_robot([](const ObservedRobot& own) { return own.id; }))
      .def_property_readonly("team", of_robot([](const ObservedRobot& own) { return own.team; }))
      .def_property_readonly("pose", of_robot([](const ObservedRobot& own) { return own.pose; }),
                             "the true one")
      .def_property_readonly("believed_pose",
                             of_robot([](const ObservedRobot& own) { return own.believed.pose; }))
      .def_property_readonly("asked", of_robot([](const ObservedRobot& own) { return own.asked; }),
                             "the motion that its coordinator asked for")
      .def_property_readonly("command",
                             of_robot([](const ObservedRobot& own) { return own.command; }),
                             "the same, as the drive can make it")
      .def_property_readonly("moving",
                             of_robot([](const ObservedRobot& own) { return own.moving; }),
                             "the true motion")
      .def_property_readonly("distance_m",
                             of_robot([](const ObservedRobot& own) { return own.distance_m; }),
                             "driven so far")
      .def_property_readonly("energy",
                             of_robot([](const ObservedRobot& own) { return own.energy; }))
      .def_property_readonly("energy_used",
                             of_robot([](const ObservedRobot& own) { return own.energy_used; }))
      .def_property_readonly("capacity",
                             of_robot([](const ObservedRobot& own) { return own.capacity; }))
      .def_property_readonly("collisions",
                             of_robot([](const ObservedRobot& own) { return own.collisions; }))
      .def_property_readonly("collected",
                             of_robot([](const ObservedRobot& own) { return own.collected; }))
      .def_property_readonly("is_leader",
                             of_robot([](const ObservedRobot& own) { return own.is_leader; }))
      .def_property_readonly("charging",
                             of_robot([](const ObservedRobot& own) { return own.charging; }))
      .def_property_readonly("empty", of_robot([](const ObservedRobot& own) { return own.empty; }),
                             "its battery is")
      .def_property_readonly("published", of_robot([](const ObservedRobot& own) {
                               return numbers_of(own.published, own.numbers);
                             }),
                             "numbers that its plugins publish: {\"orbit.distance\": 0.4}")
      .def_property_readonly(
          "behaviors", of_robot([](const ObservedRobot& own) {
            py::list all;
            for (const ObservedBehavior& each : own.behaviors) {
              all.append(named("ObservedBehavior")(each.path, each.plugin, each.asked, each.command,
                                                   each.activation, each.share, each.robot_share));
            }
            return all;
          }));
}

}  // namespace

void bind_world_view(py::module_& module) {
  bind_robots(module);
  py::class_<WorldNow>(module, "WorldNow", "The world as measures and rules see it, during a call.")
      .def_property_readonly(
          "time", [](const WorldNow& now) { return now->time_s; }, "s")
      .def_property_readonly(
          "step", [](const WorldNow& now) { return now->step_s; }, "s")
      .def_property_readonly(
          "period", [](const WorldNow& now) { return now->period_s; }, "s")
      .def_property_readonly(
          "is_start", [](const WorldNow& now) { return now->is_start; }, "before the first step")
      .def_property_readonly(
          "decided", [](const WorldNow& now) { return now->decided; },
          "robots decided in the step just made")
      .def_property_readonly(
          "arena",
          [](const WorldNow& now) {
            return py::make_tuple(now->arena_length_m, now->arena_width_m);
          },
          "(length, width) in m; its middle is the origin")
      .def_property_readonly(
          "teams",
          [](const WorldNow& now) {
            py::list teams;
            for (const std::string_view team : now->teams) teams.append(py::str(team));
            return teams;
          },
          "their names")
      .def_property_readonly(
          "robots",
          [](const WorldNow& now) {
            py::list robots;
            for (std::size_t i = 0; i < now->robots.size(); ++i) {
              robots.append(RobotView{now.observation, i});
            }
            return robots;
          },
          "in the order of the world file")
      .def(
          "robot",
          [](const WorldNow& now, const std::string& id) {
            const ObservedRobot& found = now->robot(id);
            return RobotView{now.observation,
                             static_cast<std::size_t>(&found - now->robots.data())};
          },
          py::arg("id"), "The robot with this id.")
      .def_property_readonly(
          "poses", [](const WorldNow& now) { return poses(*now); },
          "an array (robots, 3): x, y, heading")
      .def_property_readonly(
          "energies",
          [](const WorldNow& now) {
            return of_all(*now, [](const ObservedRobot& robot) { return robot.energy; });
          },
          "in the battery of each robot, units")
      .def_property_readonly(
          "distances",
          [](const WorldNow& now) {
            return of_all(*now, [](const ObservedRobot& robot) { return robot.distance_m; });
          },
          "driven by each robot so far, m")
      .def_property_readonly(
          "obstacles", [](const WorldNow& now) { return obstacles(*now); },
          "boxes and resources that are there: id, kind, team, pose")
      .def_property_readonly(
          "events",
          [](const WorldNow& now) {
            py::list events;
            for (const ObservedEvent& each : now->events) {
              events.append(py::make_tuple(each.name, each.robot));
            }
            return events;
          },
          "(name, id of the robot) since the last observation")
      .def(
          "field", [](const WorldNow& now, const std::string& id) { return field(*now, id); },
          py::arg("id"), "The cells of a field: rows from south to north.")
      .def_property_readonly(
          "published", [](const WorldNow& now) { return numbers_of(now->published, now->numbers); },
          "numbers that measures and rules publish");
}

}  // namespace elsie::python
