#include "elsie/world/values.h"

#include <algorithm>
#include <charconv>

namespace elsie::world {

namespace {

constexpr const char* kHex = "0123456789abcdefABCDEF";

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_id(std::string_view text) {
  return !text.empty() && is_letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
  });
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         text.substr(1).find_first_not_of(kHex) == std::string_view::npos;
}

}  // namespace

Field field_of(const ParameterDeclaration& parameter) {
  Field field;
  field.name = parameter.name;
  field.type = parameter.type;
  field.facts = parameter.facts;
  field.required = parameter.facts.required;
  field.cost = parameter.facts.live ? Cost::value : Cost::object;
  if (!field.required) {
    field.default_value = parameter.default_value;
  }
  field.lowest = parameter.lowest;
  field.highest = parameter.highest;
  return field;
}

Parsed parse_value(const Field& field, std::string_view text) {
  const bool has_form = field.form == TextForm::id       ? is_id(text)
                        : field.form == TextForm::colour ? is_colour(text)
                                                         : true;
  return has_form ? plugin::parse_value(field, text) : Parsed{std::nullopt, expectation(field)};
}

std::string expectation(const Field& field) {
  switch (field.form) {
    case TextForm::id:
      return "a name that starts with a letter or '_' and goes on with letters, digits, '_', '-' "
             "or '.'";
    case TextForm::colour:
      return "a colour like '#d03030' (red, green and blue, two hexadecimal digits each)";
    case TextForm::any:
      break;
  }
  return plugin::allowed_values(field);
}

std::string format_colour(const Colour& colour) {
  std::string text = "#";
  for (const unsigned part : {colour.red, colour.green, colour.blue}) {
    text += kHex[part / 16];
    text += kHex[part % 16];
  }
  return text;
}

Colour colour_of(std::string_view text) {
  const auto part = [&](std::size_t at) {
    std::uint8_t value = 0;
    std::from_chars(text.data() + at, text.data() + at + 2, value, 16);
    return value;
  };
  return {part(1), part(3), part(5)};
}

}  // namespace elsie::world
