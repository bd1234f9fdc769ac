#include "given.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "elsie/world/object_reader.h"
#include "elsie/world/values.h"

namespace elsie::layouts {

Given::Given(const world::ElementSpec& spec, const Element& element, Problems& problems)
    : spec_(spec), element_(element) {
  // The elements in it are read separately.
  Element own = element;
  std::erase_if(own.children, [&](const Element& child) { return spec.child(child.name); });
  world::read_object(spec, own, nullptr, problems);
}

std::optional<ParameterValue> Given::value(const char* name) const {
  const world::AttributeSpec& known = *spec_.attribute(name);
  const world::Attribute* const attribute = element_.find(name);
  // A value that is not allowed has already been reported.
  const auto read = attribute ? world::parse_value(known, attribute->value).value : std::nullopt;
  return read ? read : known.default_value;
}

std::optional<double> Given::number(const char* name) const {
  const auto found = value(name);
  return found ? std::optional(std::get<double>(*found)) : std::nullopt;
}

std::optional<int> Given::whole(const char* name) const {
  const auto found = value(name);
  return found ? std::optional(static_cast<int>(std::get<std::int64_t>(*found))) : std::nullopt;
}

std::optional<std::uint64_t> Given::seed(const char* name) const {
  const auto found = value(name);
  return found ? std::optional(static_cast<std::uint64_t>(std::get<std::int64_t>(*found)))
               : std::nullopt;
}

bool Given::flag(const char* name) const { return std::get<bool>(*value(name)); }

std::string Given::text(const char* name) const {
  const auto found = value(name);
  return found ? std::get<std::string>(*found) : std::string();
}

}  // namespace elsie::layouts
