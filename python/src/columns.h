// The columns of a structured array of numpy.
#pragma once

#include <cstddef>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include <pybind11/numpy.h>

#include "elsie/api/reading.h"

#include "bindings.h"

namespace elsie::python {

struct Column {
  std::string name;
  std::string format;    // as numpy writes it: "<f8"
  std::size_t size;      // bytes of a number
  std::size_t most = 0;  // numbers in a row; 0: one that is no array
  std::size_t at = 0;    // bytes from the beginning of a row

  std::size_t bytes() const { return size * (most > 0 ? most : 1); }
  /// NaN, or zero in whole numbers, in all places.
  void clear(std::byte* row) const;
};

/// A column for a text of so many letters, for one of this type, and for counts.
Column text_column(std::string name, std::size_t letters);
Column column_of(std::string name, FieldType type, std::size_t most = 0);

/// Ids are ASCII; of other texts, each byte becomes a letter.
void put_text(std::string_view text, const Column& column, std::byte* row);
template <class Number>
void put_number(Number number, const Column& column, std::byte* row) {
  std::memcpy(row + column.at, &number, sizeof number);
}

class Columns {
 public:
  /// Appends a column, behind the others in memory.
  std::size_t add(Column column);
  std::size_t row_bytes() const { return bytes_; }
  std::size_t size() const { return all_.size(); }
  const Column& operator[](std::size_t i) const { return all_[i]; }
  py::dtype dtype() const;

 private:
  std::vector<Column> all_;
  std::size_t bytes_ = 0;
};

}  // namespace elsie::python
