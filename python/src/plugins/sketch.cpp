// Sketches of plugins in Python.
#include "sketch.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include <pybind11/stl.h>

#include "elsie/api/sketch.h"
#include "elsie/base/near_name.h"

#include "lent.h"

namespace elsie::python {
namespace {

using Place = std::vector<double>;  // x, y and perhaps z
using Sketching = Lent<Sketch>;

SketchRole role_of(const std::string& name) {
  std::vector<std::string> known(std::begin(kSketchRoles), std::end(kSketchRoles));
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (known[i] == name) return static_cast<SketchRole>(i);
  }
  throw py::value_error("a sketch has no role '" + name + "'" +
                        base::near_or_all(name, known, "there are"));
}

Vector3 place_of(const Place& place) {
  if (place.size() < 2 || place.size() > 3) {
    throw py::value_error("a place in a sketch is (x, y) or (x, y, z)");
  }
  return {place[0], place[1], place.size() == 3 ? place[2] : 0.0};
}

}  // namespace

void bind_sketch(py::module_& module) {
  py::class_<Sketching, LentTo<Sketch>>(
      module, "Sketch",
      "Draws into the picture of the world. Roles: range, hit, field, target, wish, belief. Places "
      "are (x, y) or (x, y, z), in m, in the frame of the robot; of a measure, in the world.")
      .def(
          "point",
          [](Sketching& self, const std::string& role, const Place& place) {
            self->point(role_of(role), place_of(place));
          },
          py::arg("role"), py::arg("place"), "A point.")
      .def(
          "line",
          [](Sketching& self, const std::string& role, const std::vector<Place>& places) {
            std::vector<Vector3> all;
            for (const Place& each : places) all.push_back(place_of(each));
            self->line(role_of(role), all);
          },
          py::arg("role"), py::arg("places"), "A line through all these places.")
      .def(
          "arrow",
          [](Sketching& self, const std::string& role, const Place& from, const Place& to) {
            self->arrow(role_of(role), place_of(from), place_of(to));
          },
          py::arg("role"), py::arg("start"), py::arg("end"), "An arrow with its head at `end`.")
      .def(
          "circle",
          [](Sketching& self, const std::string& role, const Place& middle, double radius_m) {
            self->circle(role_of(role), place_of(middle), radius_m);
          },
          py::arg("role"), py::arg("middle"), py::arg("radius_m"), "A circle that lies flat.")
      .def(
          "text",
          [](Sketching& self, const std::string& role, const Place& place,
             const std::string& text) { self->text(role_of(role), place_of(place), text); },
          py::arg("role"), py::arg("place"), py::arg("text"), "A short text at a place.")
      .def(
          "in_world", [](Sketching& self, bool yes) { self->in_world(yes); }, py::arg("yes") = true,
          "Places of the marks that follow are in the frame of the world.");
}

}  // namespace elsie::python
