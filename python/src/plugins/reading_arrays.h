// The readings of a robot as arrays of numpy.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "elsie/api/perception.h"

#include "lent.h"

namespace elsie::python {

namespace py = pybind11;

using LentPerception = LentTo<const Perception>;

/// The readings of one kind: `now.readings["range"]`. Its attributes are arrays, a row for each
/// sensor, filled when they are first read in a call. An array that the script keeps is not written
/// again.
class ReadingArrays {
 public:
  /// `group`: the name of a list of structs in the reading; empty: the fields outside of such.
  ReadingArrays(LentPerception perception, std::size_t place, std::string group);

  /// Whether it is for these readings. Otherwise a new one is made.
  bool fits(const ReadingGroup& group) const;
  /// The attribute of this name; null: there is none.
  PyObject* find(PyObject* name);
  py::list names() const;
  std::size_t size() const { return sensors_; }

 private:
  struct Field {
    PyObject* name;  // interned, never released
    FieldDeclaration declared;
    enum class Source { stored, visited, picture, list, ids, azimuth, pitch, place, age } source;
    std::uint64_t call = 0;  // when `value` was filled
    py::object value{};
  };

  void add(const char* name, Field::Source source);
  void add(const FieldDeclaration& declared, Field::Source source);
  /// Throws std::runtime_error when the call is over, or the robot has other sensors by now.
  const ReadingGroup& group() const;
  void fill(Field& field);
  void fill_stored(Field& field, std::span<const SensedReading> readings);
  py::object visited(const Field& field, const ReadingGroup& group) const;
  py::object pictures(const Field& field, const ReadingGroup& group) const;
  py::object of_sensors(const Field& field, std::span<const SensedReading> readings) const;

  LentPerception perception_;
  std::size_t place_;
  std::string list_;  // the group of its fields
  const char* kind_;
  const ReadingDeclaration* declaration_;
  std::size_t sensors_;
  std::vector<Field> fields_;
};

void bind_reading_arrays(py::module_& module);

}  // namespace elsie::python
