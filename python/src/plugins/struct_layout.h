// Structs that are laid out at run time: readings, commands and messages that a script declares.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "elsie/api/message.h"
#include "elsie/api/reading.h"

namespace elsie::python {

namespace py = pybind11;

/// The layout of a struct of numbers. One that a script declares consists of doubles, as a struct
/// of C++ with these members would be; an array in it is a std::array.
class StructLayout {
 public:
  struct Field {
    std::string name, unit;
    FieldType type = FieldType::real64;
    bool is_array = false;
    std::size_t size = 1;
    std::size_t offset = 0;
    bool is_listed = true;  // by visit()
  };

  /// Of an `elsie.Struct`, or of the name of one of Elsie's own kinds: "range", "proximity".
  static std::shared_ptr<const StructLayout> of(py::handle declared);

  const ReadingDeclaration& declaration() const { return declaration_; }
  ReadingKind kind() const { return kind_; }
  const std::vector<Field>& fields() const { return fields_; }

  std::shared_ptr<void> blank() const;
  void clear(void* value) const;
  void copy(const void* from, void* to) const;
  /// Throws base::Error with a sentence for a number that is not finite. `what`: "reading".
  void check(const void* value, const std::string& what) const;
  void visit(const void* value, const FieldVisit& each) const;
  /// Writes numbers that a script gives: a dict, or the only number. `what`: "its reading". Throws
  /// base::Error with a sentence when one is missing, or there is no such one, or not so many.
  void fill(void* value, py::handle given, const std::string& what) const;
  /// An object with the numbers as attributes.
  py::object told(const void* value) const;

 private:
  std::vector<Field> fields_;
  ReadingDeclaration declaration_;
  ReadingKind kind_;
};

/// A message with these numbers.
std::shared_ptr<const AnyMessage> made_message(py::handle declared, py::handle numbers);

/// A text that lives as long as the process, each once: names of kinds are compared by address
/// first.
const char* lasting_text(const std::string& text);

}  // namespace elsie::python
