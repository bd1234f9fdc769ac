#include "reading_arrays.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "elsie/base/words.h"

#include "field_size.h"
#include "image_array.h"

namespace elsie::python {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// What Elsie's own readings hold besides the fields that they list.
std::vector<FieldDeclaration> unlisted(std::string_view kind) {
  const auto number = [](const char* name, FieldType type, std::size_t offset) {
    return FieldDeclaration{"", name, "", type, false, offset, true};
  };
  if (kind == RangeReading::kind) {
    return {number("max_range_m", FieldType::real64, offsetof(RangeReading, max_range_m))};
  }
  if (kind == ProximityReading::kind) {
    return {number("max_range_m", FieldType::real64, offsetof(ProximityReading, max_range_m))};
  }
  if (kind == VisionReading::kind) {
    return {number("width", FieldType::int32, offsetof(VisionReading, width)),
            number("height", FieldType::int32, offsetof(VisionReading, height)),
            number("horizontal_fov_rad", FieldType::real64,
                   offsetof(VisionReading, horizontal_fov_rad))};
  }
  return {};
}

py::dtype dtype_of(FieldType type) {
  switch (type) {
    case FieldType::boolean:
      return py::dtype::of<bool>();
    case FieldType::int8:
      return py::dtype::of<std::int8_t>();
    case FieldType::int16:
      return py::dtype::of<std::int16_t>();
    case FieldType::int32:
      return py::dtype::of<std::int32_t>();
    case FieldType::int64:
      return py::dtype::of<std::int64_t>();
    case FieldType::uint8:
      return py::dtype::of<std::uint8_t>();
    case FieldType::uint16:
      return py::dtype::of<std::uint16_t>();
    case FieldType::uint32:
      return py::dtype::of<std::uint32_t>();
    case FieldType::uint64:
      return py::dtype::of<std::uint64_t>();
    case FieldType::real32:
      return py::dtype::of<float>();
    case FieldType::real64:
    case FieldType::picture:
      return py::dtype::of<double>();
  }
  return py::dtype::of<double>();
}

PyObject* interned(const std::string& name) { return PyUnicode_InternFromString(name.c_str()); }

/// The attribute lookup of ReadingArrays: its own names first, without the cost of a call.
PyObject* attribute_of_readings(PyObject* self, PyObject* name) {
  auto* const arrays = static_cast<ReadingArrays*>(
      reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr());
  if (!arrays) return PyObject_GenericGetAttr(self, name);  // it was never made
  try {
    if (PyObject* const found = arrays->find(name)) return found;
  } catch (py::error_already_set& error) {
    error.restore();
    return nullptr;
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
    return nullptr;
  }
  PyObject* const other = PyObject_GenericGetAttr(self, name);
  if (!other && PyErr_ExceptionMatches(PyExc_AttributeError)) {
    PyErr_Clear();
    std::vector<std::string> names;
    for (const py::handle each : arrays->names()) names.push_back(each.cast<std::string>());
    PyErr_SetString(PyExc_AttributeError,
                    ("these readings have no '" + py::cast<std::string>(py::handle(name)) +
                     "'; they have " + base::joined(names))
                        .c_str());
  }
  return other;
}

}  // namespace

ReadingArrays::ReadingArrays(LentPerception perception, std::size_t place, std::string list)
    : perception_(std::move(perception)), place_(place), list_(std::move(list)) {
  const ReadingGroup& group = (**perception_).all_readings()[place_];
  kind_ = group.kind.name;
  declaration_ = group.declaration;
  sensors_ = group.readings.size();
  using Source = Field::Source;
  if (declaration_) {
    for (const FieldDeclaration& field : declaration_->fields) {
      if (field.group == list_) {
        add(field, field.type == FieldType::picture ? Source::picture
                   : field.is_single                ? Source::stored
                                                    : Source::visited);
      } else if (list_.empty() &&
                 (fields_.empty() || fields_.back().declared.name != field.group)) {
        FieldDeclaration structs;
        structs.name = field.group;
        add(structs, Source::list);
      }
    }
  }
  if (!list_.empty()) return;
  for (const FieldDeclaration& field : unlisted(kind_)) add(field, Source::stored);
  add("ids", Source::ids);
  add("azimuth_rad", Source::azimuth);
  add("pitch_rad", Source::pitch);
  add("places", Source::place);
  add("age_s", Source::age);
}

void ReadingArrays::add(const char* name, Field::Source source) {
  FieldDeclaration declared;
  declared.name = name;
  add(declared, source);
}
void ReadingArrays::add(const FieldDeclaration& declared, Field::Source source) {
  fields_.push_back({interned(declared.name), declared, source});
}

bool ReadingArrays::fits(const ReadingGroup& group) const {
  return group.kind.name == kind_ && group.declaration == declaration_ &&
         group.readings.size() == sensors_;
}

const ReadingGroup& ReadingArrays::group() const {
  const auto groups = (**perception_).all_readings();
  if (place_ >= groups.size() || !fits(groups[place_])) {
    throw std::runtime_error(
        "the robot has other sensors than when these readings were taken; take them from "
        "`now.readings` again");
  }
  return groups[place_];
}

py::list ReadingArrays::names() const {
  py::list names;
  for (const Field& field : fields_) names.append(py::str(field.declared.name));
  return names;
}

PyObject* ReadingArrays::find(PyObject* name) {
  auto found = std::find_if(fields_.begin(), fields_.end(),
                            [&](const Field& field) { return field.name == name; });
  if (found == fields_.end() && !PyUnicode_CHECK_INTERNED(name)) {
    found = std::find_if(fields_.begin(), fields_.end(), [&](const Field& field) {
      return PyUnicode_Compare(field.name, name) == 0;
    });
  }
  if (found == fields_.end()) return nullptr;
  const Lent<const Perception>& lent = *perception_;
  if (!lent.is_valid() || found->call != lent.call) {
    fill(*found);
    found->call = lent.call;
  }
  return py::object(found->value).release().ptr();
}

void ReadingArrays::fill(Field& field) {
  const ReadingGroup& group = this->group();
  using Source = Field::Source;
  switch (field.source) {
    case Source::stored:
      return fill_stored(field, group.readings);
    case Source::visited:
      field.value = visited(field, group);
      return;
    case Source::picture:
      field.value = pictures(field, group);
      return;
    case Source::list:
      if (!field.value)
        field.value = py::cast(ReadingArrays(perception_, place_, field.declared.name));
      return;
    default:
      field.value = of_sensors(field, group.readings);
  }
}

void ReadingArrays::fill_stored(Field& field, std::span<const SensedReading> readings) {
  // Only this object knows the array: it is written again.
  if (!field.value || Py_REFCNT(field.value.ptr()) > 1) {
    field.value = py::array(dtype_of(field.declared.type),
                            py::array::ShapeContainer{static_cast<py::ssize_t>(readings.size())});
  }
  auto* to = static_cast<char*>(py::reinterpret_borrow<py::array>(field.value).mutable_data());
  const std::size_t offset = field.declared.offset, bytes = size_of(field.declared.type);
  if (bytes == 8) {
    for (const SensedReading& reading : readings) {
      std::memcpy(to, static_cast<const char*>(reading.value) + offset, 8);
      to += 8;
    }
    return;
  }
  for (const SensedReading& reading : readings) {
    std::memcpy(to, static_cast<const char*>(reading.value) + offset, bytes);
    to += bytes;
  }
}

/// Arrays, and numbers of structs in lists: a row for each sensor, NaN where there is none.
py::object ReadingArrays::visited(const Field& field, const ReadingGroup& group) const {
  std::vector<std::vector<double>> rows(group.readings.size());
  std::size_t columns = 0;
  bool is_full = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    declaration_->visit(group.readings[i].value, [&](const ReadingField& each) {
      if (each.name != field.declared.name || each.group != field.declared.group) return;
      for (std::size_t n = 0; n < each.size; ++n) {
        rows[i].push_back(n < each.count ? each.number(n) : kNone);
      }
      is_full = is_full && !each.varies && each.group.empty();
    });
    columns = std::max(columns, rows[i].size());
  }
  py::array_t<double> numbers({rows.size(), columns});
  double* to = numbers.mutable_data();
  for (const std::vector<double>& row : rows) {
    is_full = is_full && row.size() == columns;
    to = std::fill_n(std::copy(row.begin(), row.end(), to), columns - row.size(), kNone);
  }
  if (is_full && field.declared.type != FieldType::real64) {
    return numbers.attr("astype")(dtype_of(field.declared.type));
  }
  return numbers;
}

/// A list of arrays (rows, columns, channels), one for each sensor.
py::object ReadingArrays::pictures(const Field& field, const ReadingGroup& group) const {
  py::list pictures;
  for (const SensedReading& reading : group.readings) {
    declaration_->visit(reading.value, [&](const ReadingField& each) {
      if (each.name != field.declared.name || each.group != field.declared.group) return;
      pictures.append(array_of(each.picture()));
    });
  }
  return pictures;
}

py::object ReadingArrays::of_sensors(const Field& field,
                                     std::span<const SensedReading> readings) const {
  using Source = Field::Source;
  if (field.source == Source::ids) {
    py::list ids;
    for (const SensedReading& reading : readings) ids.append(py::str(reading.sensor));
    return ids;
  }
  if (field.source == Source::place) {
    py::array_t<double> places({readings.size(), std::size_t{3}});
    double* to = places.mutable_data();
    for (const SensedReading& reading : readings) {
      const Vector3& at = reading.mounting->position;
      *to++ = at.x, *to++ = at.y, *to++ = at.z;
    }
    return places;
  }
  py::array_t<double> numbers(static_cast<py::ssize_t>(readings.size()));
  double* to = numbers.mutable_data();
  for (const SensedReading& reading : readings) {
    *to++ = field.source == Source::azimuth ? reading.mounting->azimuth_rad
            : field.source == Source::pitch ? reading.mounting->pitch_rad
                                            : reading.age_s;
  }
  return numbers;
}

void bind_reading_arrays(py::module_& module) {
  py::class_<ReadingArrays>(
      module, "Readings", py::custom_type_setup([](PyHeapTypeObject* type) {
        type->ht_type.tp_getattro = attribute_of_readings;
      }),
      "The readings of one kind. Attributes are arrays with a row for each "
      "sensor: the fields of the reading, and ids, azimuth_rad, pitch_rad, "
      "places and age_s. Lists of structs are attributes with such attributes.")
      .def("__len__", &ReadingArrays::size)
      .def("__dir__", &ReadingArrays::names);
}

}  // namespace elsie::python
