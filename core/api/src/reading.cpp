#include "elsie/api/reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "elsie/api/sensor.h"
#include "elsie/base/error.h"
#include "elsie/base/fnv1a.h"
#include "elsie/base/number_text.h"

namespace elsie {
namespace {

/// Calls `action` with the first number of the field, as a pointer of its type.
template <class Action>
void with_numbers(const ReadingField& field, Action action) {
  const auto as = [&]<class Number>(Number /*type*/) {
    action(static_cast<const Number*>(field.at));
  };
  switch (field.type) {
    case FieldType::boolean:
      return as(bool{});
    case FieldType::int8:
      return as(std::int8_t{});
    case FieldType::int16:
      return as(std::int16_t{});
    case FieldType::int32:
      return as(std::int32_t{});
    case FieldType::int64:
      return as(std::int64_t{});
    case FieldType::uint8:
      return as(std::uint8_t{});
    case FieldType::uint16:
      return as(std::uint16_t{});
    case FieldType::uint32:
      return as(std::uint32_t{});
    case FieldType::uint64:
      return as(std::uint64_t{});
    case FieldType::real32:
      return as(float{});
    case FieldType::real64:
      return as(double{});
    case FieldType::picture:
      return;
  }
}

/// The nearest value of this type.
template <class Number>
Number nearest(double value) {
  if constexpr (std::is_same_v<Number, bool>) {
    return value >= 0.5;
  } else if constexpr (std::is_floating_point_v<Number>) {
    return static_cast<Number>(value);
  } else {
    constexpr auto least = std::numeric_limits<Number>::min();
    constexpr auto most = std::numeric_limits<Number>::max();
    const double rounded = std::round(value);
    if (rounded <= static_cast<double>(least)) return least;
    return rounded >= static_cast<double>(most) ? most : static_cast<Number>(rounded);
  }
}

}  // namespace

double ReadingField::number(std::size_t i) const {
  double value = 0.0;
  with_numbers(*this, [&](const auto* numbers) { value = static_cast<double>(numbers[i]); });
  return value;
}

void ReadingField::set_number(std::size_t i, double value) const {
  with_numbers(*this, [&]<class Number>(const Number* numbers) {
    const_cast<Number*>(numbers)[i] = nearest<Number>(value);
  });
}

std::string ReadingField::path() const {
  return group.empty() ? std::string(name) : std::string(group).append(".").append(name);
}

std::string ReadingField::column(std::size_t i) const {
  std::string text;
  if (!group.empty()) {
    text.append(group).append(".").append(std::to_string(item)).append(".");
  }
  text.append(name);
  return is_array ? text.append(".").append(std::to_string(i)) : text;
}

std::string FieldDeclaration::in_words() const {
  std::string words = path();
  const std::string what = type == FieldType::picture ? "a picture" : is_array ? "an array" : "";
  if (!unit.empty() || !what.empty()) {
    words += " (" + unit + (unit.empty() || what.empty() ? "" : ", ") + what + ")";
  }
  return words;
}

void ReadingDeclaration::add(const ReadingField& field, const void* fresh) {
  if (field.item > 0) return;
  const std::ptrdiff_t offset =
      static_cast<const char*>(field.at) - static_cast<const char*>(fresh);
  const bool has_offset = field.is_stored && !field.is_array && field.group.empty();
  fields.push_back({std::string(field.group), std::string(field.name), std::string(field.unit),
                    field.type, field.is_array,
                    has_offset ? static_cast<std::size_t>(offset) : std::size_t{0},
                    has_offset && field.is_number()});
}

bool ReadingDeclaration::fits(const ReadingDeclaration& other) const {
  if (size == 0 || other.size == 0) return true;
  return size == other.size && (!lists_fields || !other.lists_fields || fields == other.fields);
}

std::uint64_t ReadingDeclaration::layout() const {
  base::Fnv1a hash;
  for (const FieldDeclaration& field : fields) {
    for (const std::string* text : {&field.group, &field.name, &field.unit}) {
      hash.add(*text);
      hash.add_byte(0);
    }
    hash.add(static_cast<std::uint64_t>(field.type) * 2 + (field.is_array ? 1 : 0));
    hash.add(static_cast<std::uint64_t>(field.offset));
  }
  return std::max<std::uint64_t>(hash.value(), 1);
}

namespace detail {
namespace {

/// What is wrong with the size of an array; empty: nothing, or `field` is no array.
std::string fault_of_size(const std::string& what, const ReadingField& field,
                          const ReadingField& expected) {
  const std::string name = "'" + field.path() + "' of its " + what + " has ";
  if (field.is_array && !field.varies && field.size != expected.size) {
    return name + std::to_string(field.size) + " numbers, and " + std::to_string(expected.size) +
           " in a blank one; expected the same size in every " + what +
           ": give arrays their full size "
           "in blank()";
  }
  if (field.varies && field.size != expected.size) {
    return name + "at most " + std::to_string(field.size) + " numbers, and " +
           std::to_string(expected.size) + " in a blank one; expected the same in every " + what;
  }
  if (field.varies && field.count > field.size) {
    return name + std::to_string(field.count) + " numbers; expected at most " +
           std::to_string(field.size);
  }
  if (field.in_list && !field.group.empty() && field.size == 0) {
    return "the list '" + std::string(field.group) + "' of its " + what +
           " is longer than it may be";
  }
  return {};
}

}  // namespace

void faulty_value(const Disturbable& object, const void* value, const void* blank) {
  const std::string what = object.value_name();
  std::vector<ReadingField> expected;
  object.visit_fields(blank, [&](const ReadingField& field) { expected.push_back(field); });
  std::size_t place = 0;
  object.visit_fields(value, [&](const ReadingField& field) {
    if (place < expected.size()) {
      if (const std::string fault = fault_of_size(what, field, expected[place]); !fault.empty()) {
        throw base::Error(fault);
      }
    }
    ++place;
    for (std::size_t i = 0; field.is_number() && i < field.count; ++i) {
      if (const double number = field.number(i); !std::isfinite(number)) {
        throw base::Error("the number '" + field.column(i) + "' of its " + what + " is " +
                          base::number_text(number) + "; expected a finite number");
      }
    }
  });
  throw base::Error("its " + what + " lists other fields in visit() than a blank one; every " +
                    what + " must list the same names in the same order");
}

}  // namespace detail
}  // namespace elsie
