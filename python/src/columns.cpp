#include "columns.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "field_size.h"

namespace elsie::python {
namespace {

constexpr std::size_t kLetter = 4;  // bytes, in numpy's texts

/// As numpy writes it.
const char* format_of(FieldType type) {
  switch (type) {
    case FieldType::boolean:
      return "?";
    case FieldType::int8:
      return "i1";
    case FieldType::int16:
      return "<i2";
    case FieldType::int32:
      return "<i4";
    case FieldType::int64:
      return "<i8";
    case FieldType::uint8:
      return "u1";
    case FieldType::uint16:
      return "<u2";
    case FieldType::uint32:
      return "<u4";
    case FieldType::uint64:
      return "<u8";
    case FieldType::real32:
      return "<f4";
    default:
      return "<f8";
  }
}

template <class Number>
void fill(std::byte* at, std::size_t count, Number number) {
  for (std::size_t i = 0; i < count; ++i)
    std::memcpy(at + i * sizeof number, &number, sizeof number);
}

}  // namespace

Column text_column(std::string name, std::size_t letters) {
  letters = std::max<std::size_t>(letters, 1);
  return {std::move(name), "<U" + std::to_string(letters), kLetter * letters};
}

Column column_of(std::string name, FieldType type, std::size_t most) {
  return {std::move(name), format_of(type), size_of(type), most};
}

void Column::clear(std::byte* row) const {
  const std::size_t count = std::max<std::size_t>(most, 1);
  if (format == "<f8") {
    fill(row + at, count, std::numeric_limits<double>::quiet_NaN());
  } else if (format == "<f4") {
    fill(row + at, count, std::numeric_limits<float>::quiet_NaN());
  } else {
    std::memset(row + at, 0, bytes());
  }
}

void put_text(std::string_view text, const Column& column, std::byte* row) {
  const std::size_t room = column.size / kLetter;
  for (std::size_t i = 0; i < room; ++i) {
    const std::uint32_t letter = i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
    std::memcpy(row + column.at + kLetter * i, &letter, kLetter);
  }
}

std::size_t Columns::add(Column column) {
  column.at = bytes_;
  bytes_ += column.bytes();
  all_.push_back(std::move(column));
  return all_.size() - 1;
}

py::dtype Columns::dtype() const {
  py::list fields;
  for (const Column& column : all_) {
    if (column.most > 0) {
      fields.append(py::make_tuple(column.name, column.format, py::make_tuple(column.most)));
    } else {
      fields.append(py::make_tuple(column.name, column.format));
    }
  }
  return py::dtype::from_args(fields);
}

}  // namespace elsie::python
