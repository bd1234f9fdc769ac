// The values of an element's attributes, checked against its vocabulary, with its defaults.
#pragma once

#include <optional>
#include <string>

#include "drawing.h"

namespace elsie::layouts {

class Given {
 public:
  /// Adds problems for unknown attributes and elements, and for values that are not allowed.
  Given(const world::ElementSpec& spec, const Element& element, Problems& problems);

  /// The element's value, the default, or none. The attribute must be in the vocabulary.
  std::optional<double> number(const char* name) const;
  std::optional<int> whole(const char* name) const;
  std::optional<std::uint64_t> seed(const char* name) const;
  /// These are for attributes that have a default.
  double operator[](const char* name) const { return number(name).value_or(0.0); }
  int count(const char* name) const { return whole(name).value_or(0); }
  bool flag(const char* name) const;
  std::string text(const char* name) const;

 private:
  std::optional<ParameterValue> value(const char* name) const;

  const world::ElementSpec& spec_;
  const Element& element_;
};

}  // namespace elsie::layouts
