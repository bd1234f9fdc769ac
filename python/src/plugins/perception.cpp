#include "perception.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <pybind11/stl.h>

#include "elsie/base/words.h"

#include "struct_layout.h"

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

std::size_t bytes_of(FieldType type) {
  switch (type) {
    case FieldType::boolean:
    case FieldType::int8:
    case FieldType::uint8:
      return 1;
    case FieldType::int16:
    case FieldType::uint16:
      return 2;
    case FieldType::int32:
    case FieldType::uint32:
    case FieldType::real32:
      return 4;
    default:
      return 8;
  }
}

PyObject* interned(const std::string& name) { return PyUnicode_InternFromString(name.c_str()); }

/// The attribute lookup of ReadingArrays: its own names first, without the cost of a call.
PyObject* attribute_of_readings(PyObject* self, PyObject* name) {
  auto* const arrays = static_cast<ReadingArrays*>(
      reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder().value_ptr());
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
  const ReadingGroup& group = this->group();
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
    *lent;  // throws when it is over
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
  const std::size_t offset = field.declared.offset, bytes = bytes_of(field.declared.type);
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
      const Image& image = each.picture();
      py::array_t<std::uint8_t> array(
          {image.empty() ? 0 : image.height, image.width, image.channels});
      std::copy(image.bytes.begin(), image.bytes.end(), array.mutable_data());
      pictures.append(array);
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

Now::Now()
    : perception_(std::make_shared<Lent<const Perception>>()),
      random_(std::make_shared<Lent<Random>>()) {}

py::object Now::readings() {
  const auto groups = perception().all_readings();
  bool fits = readings_ && groups.size() == made_.size();
  for (std::size_t i = 0; fits && i < groups.size(); ++i) fits = made_[i]->fits(groups[i]);
  if (!fits) {
    readings_ = py::module_::import("elsie.plugins").attr("_Readings")();
    made_.clear();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      py::object arrays = py::cast(ReadingArrays(perception_, i, ""));
      made_.push_back(arrays.cast<ReadingArrays*>());
      readings_[py::str(groups[i].kind.name)] = arrays;
    }
  }
  return readings_;
}

namespace {

/// The robot itself, `now.self`.
struct Self {
  LentPerception perception;
  const OwnState& operator*() const { return (**perception).self(); }
};
struct Team {
  LentPerception perception;
  const TeamState& operator*() const { return (**perception).team(); }
};

py::object place_or_none(const std::optional<Vector2>& place) {
  return place ? py::object(py::make_tuple(place->x, place->y)) : py::none();
}

py::object mate(const TeamMate& mate) {
  return py::module_::import("elsie.plugins")
      .attr("Mate")(mate.id, mate.pose, mate.distance_m, mate.bearing_rad, mate.is_leader,
                    mate.team_index);
}

template <class Get>
auto of_self(Get get) {
  return [get](const Self& self) { return get(*self); };
}

void bind_self(py::module_& module) {
  py::class_<Self>(module, "Self", "The robot itself: its pose and motion are what it believes.")
      .def_property_readonly("id", of_self([](const OwnState& own) { return own.id; }))
      .def_property_readonly("pose", of_self([](const OwnState& own) { return own.pose; }))
      .def_property_readonly("commanded",
                             of_self([](const OwnState& own) { return own.commanded; }),
                             "The last command, as the drive can make it.")
      .def_property_readonly("moving", of_self([](const OwnState& own) { return own.moving; }))
      .def_property_readonly("odometry", of_self([](const OwnState& own) { return own.odometry; }),
                             "The motion of its wheels, if none slips.")
      .def_property_readonly("has_lateral",
                             of_self([](const OwnState& own) { return own.channels.lateral; }),
                             "Whether its drive can move it to the side.")
      .def_property_readonly("wheel_radius_m",
                             of_self([](const OwnState& own) { return own.wheels.radius; }))
      .def_property_readonly("half_axle_m",
                             of_self([](const OwnState& own) { return own.wheels.half_axle; }))
      .def_property_readonly("length_m", of_self([](const OwnState& own) { return own.length_m; }))
      .def_property_readonly("width_m", of_self([](const OwnState& own) { return own.width_m; }))
      .def_property_readonly("max_speed_m_s",
                             of_self([](const OwnState& own) { return own.max_speed_m_s; }))
      .def_property_readonly("max_wheel_rate",
                             of_self([](const OwnState& own) { return own.max_wheel_rate(); }),
                             "rad/s")
      .def_property_readonly("coverage_m",
                             of_self([](const OwnState& own) { return own.coverage_m; }))
      .def_property_readonly("is_leader",
                             of_self([](const OwnState& own) { return own.is_leader; }))
      .def_property_readonly("team_index",
                             of_self([](const OwnState& own) { return own.team_index; }))
      .def_property_readonly("energy", of_self([](const OwnState& own) { return own.energy; }))
      .def_property_readonly("capacity", of_self([](const OwnState& own) { return own.capacity; }))
      .def_property_readonly("charging", of_self([](const OwnState& own) { return own.charging; }))
      .def_property_readonly(
          "held", of_self([](const OwnState& own) {
            py::list held;
            for (const HeldThing& thing : own.held) {
              held.append(py::module_::import("elsie.plugins")
                              .attr("Held")(thing.id, thing.actuator, thing.moves));
            }
            return held;
          }),
          "What it holds: id, actuator, moves.")
      .def(
          "motion",
          [](const Self& self, double left, double right) {
            return (*self).wheels.motion({left, right});
          },
          py::arg("left"), py::arg("right"),
          "The motion of wheels that turn at these rates, rad/s.")
      .def(
          "wheel_rates",
          [](const Self& self, const Motion& motion) {
            const WheelRates rates = (*self).wheels.wheel_rates(motion);
            return py::make_tuple(rates.left, rates.right);
          },
          py::arg("motion"), "The rates of the wheels (left, right) for a motion, rad/s.");

  py::class_<Team>(module, "Team", "The team of the robot.")
      .def_property_readonly("name", [](const Team& team) { return (*team).name; })
      .def_property_readonly(
          "mates",
          [](const Team& team) {
            py::list mates;
            for (const TeamMate& each : (*team).mates) mates.append(mate(each));
            return mates;
          },
          "Robots of the team whose coverage reaches this one.")
      .def_property_readonly(
          "leader",
          [](const Team& team) -> py::object {
            const TeamMate* const leader = (*team).leader();
            return leader ? mate(*leader) : py::none();
          },
          "The nearest leader among them, or None.")
      .def_property_readonly(
          "charger", [](const Team& team) { return place_or_none((*team).charger); },
          "(x, y) of the nearest charger, or None.")
      .def_property_readonly(
          "nest",
          [](const Team& team) -> py::object {
            const auto& nest = (*team).nest;
            if (!nest) return py::none();
            return py::make_tuple(nest->place.x, nest->place.y, nest->radius_m);
          },
          "(x, y, radius) of the nearest nest, or None.");
}

py::list heard(const Perception& now, const std::optional<std::string>& kind) {
  py::list all;
  for (const HeardMessage& heard : now.all_heard()) {
    if (kind && *kind != heard.message->kind().name) continue;
    py::dict numbers;
    heard.message->visit_fields([&](const ReadingField& field) {
      const py::str name(field.name.data(), field.name.size());
      if (!field.is_array) {
        numbers[name] = field.number(0);
        return;
      }
      py::list array;
      for (std::size_t i = 0; i < field.count; ++i) array.append(field.number(i));
      numbers[name] = array;
    });
    all.append(py::module_::import("elsie.plugins")
                   .attr("Heard")(heard.message->kind().name, numbers, heard.device, heard.from,
                                  heard.age_s, heard.distance_m, heard.bearing_rad,
                                  heard.elevation_rad));
  }
  return all;
}

}  // namespace

void bind_perception(py::module_& module) {
  bind_self(module);
  py::class_<ReadingArrays>(
      module, "Readings", py::custom_type_setup([](PyHeapTypeObject* type) {
        type->ht_type.tp_getattro = attribute_of_readings;
      }),
      "The readings of one kind. Attributes are arrays with a row for each "
      "sensor: the fields of the reading, and ids, azimuth_rad, pitch_rad, "
      "places and age_s. Lists of structs are attributes with such attributes.")
      .def("__len__", &ReadingArrays::size)
      .def("__dir__", &ReadingArrays::names);
  py::class_<Now>(module, "Now", "What a behaviour or coordinator perceives, during a call.")
      .def_property_readonly(
          "time", [](const Now& now) { return now.perception().time_s(); },
          "s, since the start of the run")
      .def_property_readonly(
          "period", [](const Now& now) { return now.perception().period_s(); },
          "s, from one decision to the next")
      .def_property_readonly("readings", &Now::readings,
                             "The readings by their kinds: now.readings[\"range\"].distance_m.")
      .def_property_readonly(
          "self",
          [](const Now& now) {
            now.perception();
            return Self{now.lent()};
          },
          "The robot itself.")
      .def_property_readonly("team", [](const Now& now) { return Team{now.lent()}; })
      .def_property_readonly(
          "events",
          [](const Now& now) {
            py::list events;
            for (const Event& event : now.perception().events()) events.append(event.name);
            return events;
          },
          "The names of events of the last control period.")
      .def(
          "heard",
          [](const Now& now, const std::optional<std::string>& kind) {
            return heard(now.perception(), kind);
          },
          py::arg("kind") = py::none(), "The messages of this period, of one kind or of all.")
      .def_property_readonly(
          "random", [](const Now& now) { return now.random(); },
          "The object's own stream of random numbers.");
}

}  // namespace elsie::python
