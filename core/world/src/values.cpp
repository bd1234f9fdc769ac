#include "elsie/world/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "elsie/base/near_name.h"

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

bool in_range(const ParameterFacts& facts, double value) {
  return std::isfinite(value) && value >= facts.min && value > facts.above && value <= facts.max;
}

Parsed accepted(ParameterValue value) { return {std::move(value), ""}; }
Parsed refused(std::string problem) { return {std::nullopt, std::move(problem)}; }

template <class Number>
Parsed parse_number(const Field& field, std::string_view text) {
  Number number{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  std::string hint;
  if (result.ec == std::errc::result_out_of_range) {
    hint = "; this number is too large or too small to be represented";
  } else if (result.ec != std::errc() || result.ptr != end) {
    const std::string& unit = field.facts.unit;
    const bool has_unit = result.ec == std::errc() && is_letter(text.back());
    hint = text.find(',') != std::string_view::npos
               ? "; decimals are written with a point, as in 1.5"
           : has_unit ? "; write the number only" + (unit.empty() ? "" : "; the unit is " + unit)
           : text.find_first_of(" \t\n\r") != std::string_view::npos ? "; without blanks"
                                                                     : "";
  } else if (const auto value = static_cast<double>(number); in_range(field.facts, value)) {
    if (value >= field.lowest && value <= field.highest) return accepted(number);
    hint = "; this number is beyond what can be stored";
  }
  return refused("expected " + expectation(field) + hint);
}

Parsed parse_list(const Field& field, std::string_view text) {
  std::vector<double> numbers;
  std::size_t at = 0;
  while (true) {
    at = text.find_first_not_of(" \t\n\r", at);
    if (at == std::string_view::npos) return accepted(std::move(numbers));
    const std::size_t end = std::min(text.find_first_of(" \t\n\r", at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const Parsed number = parse_number<double>(field, word);
    if (!number.value) {
      return refused("expected " + expectation(field) + "; '" + std::string(word) +
                     "' is none of those");
    }
    numbers.push_back(std::get<double>(*number.value));
    at = end;
  }
}

Parsed parse_text(const Field& field, std::string_view text) {
  const auto& choices = field.facts.choices;
  const bool good = !choices.empty()
                        ? std::find(choices.begin(), choices.end(), text) != choices.end()
                    : field.form == TextForm::id     ? is_id(text)
                    : field.form == TextForm::colour ? is_colour(text)
                                                     : true;
  if (good) return accepted(std::string(text));
  return refused("expected " + expectation(field) +
                 (choices.size() > 1 ? base::did_you_mean(std::string(text), choices) : ""));
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
  switch (field.type) {
    case ParameterType::real:
      return parse_number<double>(field, text);
    case ParameterType::integer:
      return parse_number<std::int64_t>(field, text);
    case ParameterType::boolean:
      if (text == "true" || text == "false") return accepted(text == "true");
      return refused("expected " + expectation(field));
    case ParameterType::reals:
      return parse_list(field, text);
    case ParameterType::file:
    case ParameterType::text:
      break;
  }
  return parse_text(field, text);
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
  ParameterDeclaration parameter;
  parameter.name = field.name;
  parameter.type = field.type;
  parameter.facts = field.facts;
  parameter.lowest = field.lowest;
  parameter.highest = field.highest;
  return plugin::allowed_values(parameter) +
         (field.type == ParameterType::reals ? ", separated by blanks" : "");
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
