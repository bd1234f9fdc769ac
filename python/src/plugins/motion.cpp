#include "motion.h"

#include <cmath>
#include <string>

#include <pybind11/stl.h>

#include "elsie/api/geometry.h"
#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/base/random.h"

#include "perception.h"
#include "struct_layout.h"

namespace elsie::python {
namespace {

/// The object of C++ in one of Python, if it is exactly of this class.
template <class T>
T* exact(py::handle given, PyTypeObject* type) {
  if (Py_TYPE(given.ptr()) != type) return nullptr;
  return static_cast<T*>(
      reinterpret_cast<py::detail::instance*>(given.ptr())->get_value_and_holder().value_ptr());
}

PyTypeObject* motion_type = nullptr;
PyTypeObject* response_type = nullptr;

[[noreturn]] void refuse(py::handle given) {
  throw base::Error("respond() returned " + py::repr(given).cast<std::string>() +
                    "; expected elsie.Motion, (elsie.Motion, activation) or elsie.Response");
}

std::string text_of(const Motion& motion) {
  return "Motion(forward=" + base::number_text(motion.forward) +
         ", lateral=" + base::number_text(motion.lateral) +
         ", turn=" + base::number_text(motion.turn) + ")";
}

/// {"red": 1.0, "angles": [0.1, 0.2]} -> red, angles.0, angles.1
NamedNumbers named_numbers(const py::kwargs& given) {
  NamedNumbers numbers;
  const auto add = [&](const std::string& name, py::handle number) {
    const double value = PyFloat_AsDouble(number.ptr());
    if (value == -1.0 && PyErr_Occurred()) throw py::error_already_set();
    numbers.emplace_back(name, value);
  };
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    if (PyNumber_Check(value.ptr()) && !PySequence_Check(value.ptr())) {
      add(name, value);
      continue;
    }
    std::size_t place = 0;
    for (const py::handle each : py::reinterpret_borrow<py::sequence>(value)) {
      add(name + "." + std::to_string(place++), each);
    }
  }
  return numbers;
}

std::string kind_of(py::handle declared) {
  return py::isinstance<py::str>(declared) ? declared.cast<std::string>()
                                           : declared.attr("kind").cast<std::string>();
}

void bind_response(py::module_& module) {
  py::enum_<Status>(module, "Status", "How what a behaviour does stands.")
      .value("running", Status::running)
      .value("success", Status::success)
      .value("failure", Status::failure);
  const Response usual;
  py::class_<Response> response(
      module, "Response",
      "The full answer of a behaviour: its motion, how much it matters, what else it does.");
  response
      .def(py::init([](const Motion& motion, double activation, double strength,
                       double speed_strength, double lateral_strength, double turn_strength,
                       std::optional<double> matters_rad, Status status, bool charge) {
             Response made(motion);
             made.activation = activation;
             made.strength = strength;
             made.speed_strength = speed_strength;
             made.lateral_strength = lateral_strength;
             made.turn_strength = turn_strength;
             made.matters_rad = matters_rad;
             made.status = status;
             made.charge = charge;
             return made;
           }),
           py::arg("motion") = Motion{}, py::arg("activation") = 1.0, py::arg("strength") = 1.0,
           py::arg("speed_strength") = 1.0, py::arg("lateral_strength") = 1.0,
           py::arg("turn_strength") = 1.0, py::arg("matters_rad") = py::none(),
           py::arg("status") = Status::running, py::arg("charge") = false)
      .def_readwrite("motion", &Response::command, "What it asks for.")
      .def_readwrite("activation", &Response::activation,
                     "How relevant the behaviour is now, in [0, 1]; 0: not active.")
      .def_readwrite("strength", &Response::strength,
                     "In [0, 1], for coordinators that resolve conflicts by strength.")
      .def_readwrite("speed_strength", &Response::speed_strength,
                     "A factor of the strength, for the forward speed.")
      .def_readwrite("lateral_strength", &Response::lateral_strength,
                     "The same for the lateral speed.")
      .def_readwrite("turn_strength", &Response::turn_strength, "The same for the turn.")
      .def_readwrite("matters_rad", &Response::matters_rad,
                     "The direction along which the motion matters; None: all of it does.")
      .def_readwrite("status", &Response::status, "How what it does stands.")
      .def_readwrite("charge", &Response::charge, "Asks to be charged.")
      .def_property_readonly(
          "events",
          [](const Response& self) {
            py::list events;
            for (const Event& event : self.events) events.append(event.name);
            return events;
          },
          "the names of those that it raises")
      .def(
          "act",
          [](Response& self, py::handle command, const std::string& by,
             const py::kwargs& numbers) -> Response& {
            self.acts.emplace_back(by, kind_of(command), named_numbers(numbers));
            return self;
          },
          py::arg("command"), py::kw_only(), py::arg("by") = "",
          "Commands an actuator: act(\"led\", red=255). The first word is the kind of command; "
          "`by` "
          "may name the actuator, otherwise it is the first that takes such commands.")
      .def(
          "say",
          [](Response& self, py::handle message, const std::string& to, const std::string& by,
             const py::kwargs& numbers) -> Response& {
            self.acts.emplace_back(by, SayCommand{made_message(message, numbers), to});
            return self;
          },
          py::arg("message"), py::kw_only(), py::arg("to") = "", py::arg("by") = "",
          "Says a message to the robot `to`, or to all that hear it: say(OFFER, x=1.0, y=2.0).")
      .def(
          "raise_event",
          [](Response& self, const std::string& name) -> Response& {
            self.events.push_back({name});
            return self;
          },
          py::arg("name"), "Raises an event that `raises` declares.");
  response_type = reinterpret_cast<PyTypeObject*>(response.ptr());
}

void bind_random(py::module_& module) {
  py::class_<Lent<Random>, LentRandom>(
      module, "Random", "A stream of random numbers: the same in each run with the same seed.")
      .def(
          "uniform",
          [](Lent<Random>& random, double low, double high) { return random->uniform(low, high); },
          py::arg("low") = 0.0, py::arg("high") = 1.0, "In [low, high).")
      .def(
          "normal",
          [](Lent<Random>& random, double mean, double deviation) {
            return random->normal(mean, deviation);
          },
          py::arg("mean") = 0.0, py::arg("deviation") = 1.0, "Normally distributed.")
      .def(
          "integer",
          [](Lent<Random>& random, std::int64_t n) {
            if (n < 1) throw py::value_error("integer() needs a number above 0");
            return std::min(n - 1,
                            static_cast<std::int64_t>(random->uniform() * static_cast<double>(n)));
          },
          py::arg("n"), "0, 1, ... or n - 1.")
      .def(
          "chance",
          [](Lent<Random>& random, double probability) { return random->chance(probability); },
          py::arg("probability"), "True with this probability.");
}

}  // namespace

const Motion* as_motion(py::handle given) { return exact<Motion>(given, motion_type); }

Response as_response(py::handle given, bool may_be_none) {
  if (const Motion* const motion = as_motion(given)) return {*motion};
  if (const auto* const response = exact<Response>(given, response_type)) return *response;
  if (may_be_none && given.is_none()) return {};
  if (!PyTuple_CheckExact(given.ptr()) || PyTuple_GET_SIZE(given.ptr()) != 2) refuse(given);
  const Motion* const motion = as_motion(PyTuple_GET_ITEM(given.ptr(), 0));
  const double activation = PyFloat_AsDouble(PyTuple_GET_ITEM(given.ptr(), 1));
  if (!motion || (activation == -1.0 && PyErr_Occurred())) {
    PyErr_Clear();
    refuse(given);
  }
  Response response(*motion);
  response.activation = activation;
  return response;
}

void bind_motion(py::module_& module) {
  py::class_<Motion> motion(module, "Motion",
                            "A motion of the robot: m/s along its heading and to the left, rad/s.");
  motion
      .def(py::init([](double forward, double turn, double lateral) {
             return Motion{forward, lateral, turn};
           }),
           py::arg("forward") = 0.0, py::arg("turn") = 0.0, py::arg("lateral") = 0.0)
      .def_readwrite("forward", &Motion::forward, "m/s, along the heading")
      .def_readwrite("lateral", &Motion::lateral, "m/s, to the left")
      .def_readwrite("turn", &Motion::turn, "rad/s, counter-clockwise")
      .def(
          "__add__", [](const Motion& a, const Motion& b) { return a + b; }, py::is_operator())
      .def(
          "__sub__", [](const Motion& a, const Motion& b) { return a - b; }, py::is_operator())
      .def(
          "__mul__", [](const Motion& a, double s) { return s * a; }, py::is_operator())
      .def(
          "__rmul__", [](const Motion& a, double s) { return s * a; }, py::is_operator())
      .def(
          "__truediv__", [](const Motion& a, double s) { return a / s; }, py::is_operator())
      .def(
          "__eq__", [](const Motion& a, const Motion& b) { return a == b; }, py::is_operator())
      .def("__repr__", text_of);
  motion_type = reinterpret_cast<PyTypeObject*>(motion.ptr());
  py::class_<Pose>(module, "Pose", "A place in m and a heading, counter-clockwise from east.")
      .def(py::init<double, double, double>(), py::arg("x") = 0.0, py::arg("y") = 0.0,
           py::arg("heading_rad") = 0.0)
      .def_readonly("x", &Pose::x, "m")
      .def_readonly("y", &Pose::y, "m")
      .def_readonly("heading_rad", &Pose::heading_rad, "counter-clockwise from the x axis")
      .def(
          "bearing", [](const Pose& self, double x, double y) { return bearing(self, x, y); },
          py::arg("x"), py::arg("y"), "The direction to a point from the heading, in (-pi, pi].")
      .def("__repr__", [](const Pose& pose) {
        return "Pose(x=" + base::number_text(pose.x) + ", y=" + base::number_text(pose.y) +
               ", heading_rad=" + base::number_text(pose.heading_rad) + ")";
      });
  bind_response(module);
  bind_random(module);
}

}  // namespace elsie::python
