#include "values.h"

#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <pybind11/stl.h>

#include "elsie/base/error.h"
#include "elsie/base/number_text.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/world/attributes.h"

namespace elsie::python {
namespace {

py::object object_of(const ParameterValue& value) {
  return std::visit([](const auto& held) -> py::object { return py::cast(held); }, value);
}

py::object value_of(const world::AttributeTarget& target) {
  std::optional<ParameterValue> value;
  if (target.attribute) {
    value = target.attribute->get(target.described.object);
  } else {
    const auto look = [&](const auto& use) {
      const auto set = use.parameters.find(target.field.name);
      if (set != use.parameters.end()) value = set->second;
    };
    target.nested.empty() ? look(*target.use)
                          : look(plugin::element_at(target.use->elements, target.nested));
  }
  if (!value) value = target.field.default_value;
  return value ? object_of(*value) : py::none();
}

}  // namespace

std::string text_of(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>() ? "true" : "false";
  if (PyIndex_Check(value.ptr())) {
    const auto whole = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (!whole) throw py::error_already_set();
    return py::str(whole);
  }
  if (PyNumber_Check(value.ptr()) && !PySequence_Check(value.ptr())) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred()) throw py::error_already_set();
    return base::number_text(number);
  }
  throw py::type_error("expected a str, bool, int or float as the value of an attribute, not " +
                       std::string(py::str(py::type::of(value).attr("__name__"))));
}

std::vector<std::pair<std::string, std::string>> edits_of(const py::list& given) {
  std::vector<std::pair<std::string, std::string>> edits;
  for (const py::handle& each : given) {
    const auto pair = each.cast<py::tuple>();
    edits.emplace_back(pair[0].cast<std::string>(), text_of(pair[1]));
  }
  return edits;
}

std::vector<std::string> texts_of(const py::list& given) {
  std::vector<std::string> texts;
  for (const auto& [path, value] : edits_of(given)) texts.push_back(path + "=" + value);
  return texts;
}

py::object value_at(const world::World& world, const plugin::Host& host, const std::string& path) {
  try {
    const world::Attributes attributes(world, host);
    const std::vector<world::AttributeTarget> targets = attributes.find(path);
    if (targets.size() == 1) return value_of(targets.front());
    py::list values;
    for (const world::AttributeTarget& target : targets) values.append(value_of(target));
    return values;
  } catch (const std::invalid_argument& error) {
    throw base::BadInput(path + ": " + error.what());
  }
}

}  // namespace elsie::python
