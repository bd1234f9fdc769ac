#include "struct_layout.h"

#include <cmath>
#include <cstring>
#include <mutex>
#include <set>

#include <pybind11/numpy.h>

#include "elsie/base/error.h"
#include "elsie/base/near_name.h"
#include "elsie/base/number_text.h"
#include "elsie/base/words.h"

namespace elsie::python {
namespace {

ReadingField field_at(const StructLayout::Field& field, const void* value) {
  ReadingField listed;
  listed.name = field.name;
  listed.unit = field.unit;
  listed.type = field.type;
  listed.is_array = field.is_array;
  listed.size = listed.count = field.size;
  listed.at = static_cast<const char*>(value) + field.offset;
  listed.is_stored = true;
  return listed;
}

double number_of(py::handle given, const std::string& what, const std::string& name) {
  const double number = PyFloat_AsDouble(given.ptr());
  if (number == -1.0 && PyErr_Occurred()) {
    PyErr_Clear();
    throw base::Error("the number '" + name + "' of " + what + " is " +
                      py::repr(given).cast<std::string>() + "; expected a number");
  }
  return number;
}

}  // namespace

const char* lasting_text(const std::string& text) {
  static std::mutex guard;
  static auto* const texts = new std::set<std::string>;
  const std::lock_guard lock(guard);
  return texts->insert(text).first->c_str();
}

std::shared_ptr<const StructLayout> StructLayout::of(py::handle declared) {
  auto layout = std::make_shared<StructLayout>();
  ReadingDeclaration& declaration = layout->declaration_;
  if (py::isinstance<py::str>(declared)) {
    if (declared.cast<std::string>() == RangeReading::kind) {
      using Own = RangeReading;
      layout->fields_ = {
          {"distance_m", "m", FieldType::real64, false, 1, offsetof(Own, distance_m), true},
          {"max_range_m", "m", FieldType::real64, false, 1, offsetof(Own, max_range_m), false},
          {"hit", "", FieldType::boolean, false, 1, offsetof(Own, hit), true}};
      declaration = ReadingDeclaration::of<Own>();
    } else {
      using Own = ProximityReading;
      layout->fields_ = {
          {"detected", "", FieldType::boolean, false, 1, offsetof(Own, detected), true},
          {"max_range_m", "m", FieldType::real64, false, 1, offsetof(Own, max_range_m), false}};
      declaration = ReadingDeclaration::of<Own>();
    }
  } else {
    declaration.kind = declared.attr("kind").cast<std::string>();
    declaration.lists_fields = true;
    for (const py::handle each : declared.attr("fields")) {
      Field& field = layout->fields_.emplace_back();
      field.name = each.attr("name").cast<std::string>();
      field.unit = each.attr("unit").cast<std::string>();
      const auto size = each.attr("size").cast<std::size_t>();
      field.is_array = size > 0;
      field.size = std::max<std::size_t>(size, 1);
      field.offset = declaration.size;
      declaration.size += field.size * sizeof(double);
    }
    const auto fresh = layout->blank();
    layout->visit(fresh.get(),
                  [&](const ReadingField& field) { declaration.add(field, fresh.get()); });
  }
  layout->kind_ = {lasting_text(declaration.kind), declaration.size, declaration.layout()};
  declaration.visit = [fields = layout->fields_](const void* value, const FieldVisit& each) {
    for (const Field& field : fields) {
      if (field.is_listed) each(field_at(field, value));
    }
  };
  return layout;
}

std::shared_ptr<void> StructLayout::blank() const {
  // Doubles: aligned for every member.
  const std::size_t words = (declaration_.size + sizeof(double) - 1) / sizeof(double);
  return std::shared_ptr<double[]>(new double[words]());
}

void StructLayout::clear(void* value) const { std::memset(value, 0, declaration_.size); }
void StructLayout::copy(const void* from, void* to) const {
  std::memcpy(to, from, declaration_.size);
}

void StructLayout::check(const void* value, const std::string& what) const {
  visit(value, [&](const ReadingField& field) {
    for (std::size_t i = 0; i < field.count; ++i) {
      if (!std::isfinite(field.number(i))) {
        throw base::Error("the number '" + field.column(i) + "' of its " + what + " is " +
                          base::number_text(field.number(i)) + "; expected a finite number");
      }
    }
  });
}

void StructLayout::visit(const void* value, const FieldVisit& each) const {
  for (const Field& field : fields_) {
    if (field.is_listed) each(field_at(field, value));
  }
}

void StructLayout::fill(void* value, py::handle given, const std::string& what) const {
  const auto set = [&](const Field& field, py::handle number) {
    const ReadingField to = field_at(field, value);
    if (!field.is_array) return to.set_number(0, number_of(number, what, field.name));
    if (!PySequence_Check(number.ptr())) {
      throw base::Error("'" + field.name + "' of " + what + " is " +
                        py::repr(number).cast<std::string>() + "; expected " +
                        base::counted(field.size, "number"));
    }
    const auto numbers = py::reinterpret_borrow<py::sequence>(number);
    if (numbers.size() != field.size) {
      throw base::Error("'" + field.name + "' of " + what + " has " +
                        base::counted(numbers.size(), "number") + "; expected " +
                        std::to_string(field.size));
    }
    for (std::size_t i = 0; i < field.size; ++i) {
      to.set_number(i, number_of(numbers[i], what, field.name));
    }
  };
  if (!PyDict_Check(given.ptr())) {
    if (fields_.size() == 1) return set(fields_.front(), given);
    throw base::Error(what + " is " + py::repr(given).cast<std::string>() +
                      "; expected a dict of its numbers");
  }
  const auto numbers = py::reinterpret_borrow<py::dict>(given);
  std::size_t used = 0;
  for (const Field& field : fields_) {
    PyObject* const number = PyDict_GetItemString(numbers.ptr(), field.name.c_str());
    if (number) {
      set(field, number);
      ++used;
    } else {
      throw base::Error(what + " lacks the number '" + field.name + "'");
    }
  }
  if (used == numbers.size()) return;
  std::vector<std::string> names;
  for (const Field& field : fields_) names.push_back(field.name);
  for (const auto& [name, number] : numbers) {
    const auto wrong = py::str(name).cast<std::string>();
    if (std::find(names.begin(), names.end(), wrong) == names.end()) {
      throw base::Error(what + " has the number '" + wrong + "', which is not declared" +
                        base::near_or_all(wrong, names, "declared are"));
    }
  }
}

py::object StructLayout::told(const void* value) const {
  static const py::handle space =
      py::object(py::module_::import("types").attr("SimpleNamespace")).release();
  py::dict numbers;
  visit(value, [&](const ReadingField& field) {
    const py::str name(field.name.data(), field.name.size());
    if (!field.is_array) {
      numbers[name] = field.number(0);
      return;
    }
    py::array_t<double> array(static_cast<py::ssize_t>(field.count));
    for (std::size_t i = 0; i < field.count; ++i) {
      array.mutable_data()[i] = field.number(i);
    }
    numbers[name] = array;
  });
  return space(**numbers);
}

std::shared_ptr<const AnyMessage> made_message(py::handle declared, py::handle numbers) {
  py::object layout_of = py::reinterpret_borrow<py::object>(declared);
  if (py::isinstance<py::str>(declared)) {  // its numbers, in the order in which they are given
    py::dict units;
    for (const auto& [name, number] : py::reinterpret_borrow<py::dict>(numbers)) {
      units[name] = py::str("");
    }
    layout_of = py::module_::import("elsie.plugins").attr("message")(declared, **units);
  }
  const std::shared_ptr<const StructLayout> layout = StructLayout::of(layout_of);
  const std::shared_ptr<void> content = layout->blank();
  const std::string what = std::string("message of the kind '") + layout->kind().name + "'";
  layout->fill(content.get(), numbers, "its " + what);
  layout->check(content.get(), what);
  return std::make_shared<const AnyMessage>(
      layout->kind(), content,
      [layout](const void* value, const FieldVisit& each) { layout->visit(value, each); });
}

}  // namespace elsie::python
