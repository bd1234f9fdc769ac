#include "elsie/plugin/parameters.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/base/near_name.h"
#include "elsie/base/thrown.h"
#include "elsie/base/words.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/error.h"

#include "text.h"

namespace elsie::plugin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr const char* kBlanks = " \t\n\r";

/// A type in words, and the alternative of ParameterValue that holds it.
struct Type {
  const char* words;
  std::size_t alternative;
  bool is_number = false;
};

Type facts_of(ParameterType type) {
  switch (type) {
    case ParameterType::real:
      return {"a number", ParameterValue(0.0).index(), true};
    case ParameterType::integer:
      return {"a whole number", ParameterValue(std::int64_t{0}).index(), true};
    case ParameterType::boolean:
      return {"true or false", ParameterValue(false).index()};
    case ParameterType::text:
      return {"a text", ParameterValue("").index()};
    case ParameterType::file:
      return {"the path of a file", ParameterValue("").index()};
    case ParameterType::reals:
      return {"a list of numbers", ParameterValue(std::vector<double>()).index(), true};
  }
  return {"a value", std::variant_size_v<ParameterValue>};
}

std::string value_text(const ParameterValue& value) {
  if (value.valueless_by_exception()) return "nothing";
  const bool has_blanks = std::holds_alternative<std::string>(value) ||
                          std::holds_alternative<std::vector<double>>(value);
  return has_blanks ? name_in_quotes(format_value(value)) : format_value(value);
}

/// "above 0", "at most 50".
std::vector<std::string> limit_texts(const Allowed& allowed) {
  const ParameterFacts& facts = allowed.facts;
  // Limits of the member's type are not mentioned, except that it has no sign.
  const double min = allowed.lowest == 0.0 ? std::max(facts.min, 0.0) : facts.min;
  std::vector<std::string> limits;
  if (facts.above > -kInfinity && facts.above >= min) {
    limits.push_back("above " + number_text(facts.above));
  } else if (min > -kInfinity) {
    limits.push_back("at least " + number_text(min));
  }
  if (facts.max < kInfinity) limits.push_back("at most " + number_text(facts.max));
  return limits;
}

/// Whether the number is in the range that the declaration gives.
bool in_range(const ParameterFacts& facts, double value) {
  return std::isfinite(value) && value >= facts.min && value > facts.above && value <= facts.max;
}

Parsed refused(const Allowed& allowed, const std::string& hint = "") {
  return {std::nullopt, allowed_values(allowed) + hint};
}

template <class Number>
Parsed parse_number(const Allowed& allowed, std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc::result_out_of_range) {
    return refused(allowed, "; this number is too large or too small to be represented");
  }
  if (error != std::errc() || rest != end) {
    const std::string& unit = allowed.facts.unit;
    const bool has_unit =
        error == std::errc() && std::isalpha(static_cast<unsigned char>(text.back()));
    const bool has_blanks = text.find_first_of(kBlanks) != std::string_view::npos;
    return refused(allowed, text.find(',') != std::string_view::npos
                                ? "; decimals are written with a point, as in 1.5"
                            : has_unit ? "; write the number only" +
                                             (unit.empty() ? "" : "; the unit is " + unit)
                            : has_blanks ? "; without blanks"
                                         : "");
  }
  const auto value = static_cast<double>(number);
  if (!in_range(allowed.facts, value)) return refused(allowed);
  if (value < allowed.lowest || value > allowed.highest) {
    return refused(allowed, "; this number is beyond what can be stored (" +
                                number_text(allowed.lowest) + " to " +
                                number_text(allowed.highest) + ")");
  }
  return {number, ""};
}

Parsed parse_list(const Allowed& allowed, std::string_view text) {
  std::vector<double> numbers;
  std::size_t at = 0;
  while ((at = text.find_first_not_of(kBlanks, at)) != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    const Parsed number = parse_number<double>(allowed, word);
    if (!number.value) return refused(allowed, "; '" + std::string(word) + "' is none of those");
    numbers.push_back(std::get<double>(*number.value));
    at = end;
  }
  return {std::move(numbers), ""};
}

Parsed parse_text(const Allowed& allowed, std::string_view text) {
  const auto& choices = allowed.facts.choices;
  if (choices.empty() || std::find(choices.begin(), choices.end(), text) != choices.end()) {
    return {std::string(text), ""};
  }
  return refused(allowed, choices.size() > 1 ? base::did_you_mean(text, choices) : "");
}

template <class Declared>
std::string did_you_mean(std::string_view name, const std::vector<Declared>& declared) {
  std::vector<std::string_view> names;
  for (const Declared& each : declared) {
    names.push_back(each.name);
  }
  return base::did_you_mean(name, names);
}

/// Adds errors for wrong names and values among the parameters of `whose`.
void check_values(const std::string& whose, const std::vector<ParameterDeclaration>& declared,
                  const std::map<std::string, ParameterValue>& given,
                  std::vector<std::string>& errors) {
  for (const auto& [name, value] : given) {
    const ParameterDeclaration* const parameter = find_declared(declared, name);
    if (!parameter) {
      errors.push_back(whose + " has no parameter '" + name + "'" + did_you_mean(name, declared));
      continue;
    }
    if (auto error = check_value(*parameter, value)) errors.push_back(std::move(*error));
  }
}

/// The same for elements inside `whose`.
void check_elements(const std::string& whose, const DeclaredElement& around,
                    const std::vector<ElementValue>& elements, std::vector<std::string>& errors) {
  for (const ElementValue& element : elements) {
    if (const auto known = around.inside(element.element)) {
      const std::string tag = "<" + element.element + ">";
      check_values(tag, known->parameters(), element.parameters, errors);
      check_elements(tag, *known, element.elements, errors);
    } else {
      errors.push_back(whose + " has no element <" + element.element + ">" +
                       base::did_you_mean(element.element, around.names_inside()));
    }
  }
}

/// An empty Coordination, for a behaviour that is only tried out.
class NothingInside final : public Coordination {
 public:
  Response respond(const Perception&) override { return {}; }
  void rate(std::span<const Motion>, std::span<double> desirability) override {
    std::fill(desirability.begin(), desirability.end(), 0.0);
  }
  CommandSets command_sets() override { return {}; }
};

/// Requires that all names are known and all values are allowed.
void set_elements(const Declaration& declaration, Component& object,
                  const std::vector<ElementValue>& elements) {
  std::set<std::size_t> cleared;
  for (const ElementValue& value : elements) {
    const ElementDeclaration* const element = find_declared(declaration.elements, value.element);
    if (cleared.insert(element->list).second) element->clear(object);
    element->append(object, value);
  }
}

}  // namespace

std::string format_value(const ParameterValue& value) {
  struct Format {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return number_text(number); }
    std::string operator()(const std::string& text) const { return text; }
    std::string operator()(const std::vector<double>& numbers) const {
      std::string list;
      for (const double number : numbers) {
        list += (list.empty() ? "" : " ") + number_text(number);
      }
      return list;
    }
  };
  return std::visit(Format{}, value);
}

std::string allowed_values(const Allowed& allowed) {
  const std::vector<std::string>& choices = allowed.facts.choices;
  if (allowed.type == ParameterType::text && !choices.empty()) {
    std::vector<std::string> names;
    std::transform(choices.begin(), choices.end(), std::back_inserter(names), name_in_quotes);
    return (names.size() == 1 ? "" : "one of ") + joined(names, ", ");
  }
  const Type type = facts_of(allowed.type);
  std::string text = type.words;
  if (!type.is_number) return text;
  const bool is_list = allowed.type == ParameterType::reals;
  const std::vector<std::string> limits = limit_texts(allowed);
  const std::string& unit = allowed.facts.unit;
  if (!limits.empty()) {
    text += (is_list ? ", each " : " ") + base::enumerated(limits);
    text += unit.empty() ? "" : " " + unit;
  } else if (!unit.empty()) {
    text += " in " + unit;
  }
  return is_list ? text + ", separated by blanks" : text;
}

Parsed parse_value(const Allowed& allowed, std::string_view text) {
  switch (allowed.type) {
    case ParameterType::real:
      return parse_number<double>(allowed, text);
    case ParameterType::integer:
      return parse_number<std::int64_t>(allowed, text);
    case ParameterType::boolean:
      return text == "true" || text == "false" ? Parsed{text == "true", ""} : refused(allowed);
    case ParameterType::reals:
      return parse_list(allowed, text);
    case ParameterType::file:
    case ParameterType::text:
      break;
  }
  return parse_text(allowed, text);
}

std::optional<std::string> check_value(const ParameterDeclaration& parameter,
                                       const ParameterValue& value) {
  const bool right_type = value.index() == facts_of(parameter.type).alternative;
  const Parsed parsed =
      right_type ? parse_value(parameter, format_value(value)) : refused(parameter);
  if (parsed.value) return std::nullopt;
  return parameter.name + " is " + value_text(value) + ", but must be " + parsed.expected;
}

void hold_nothing(const Declaration& declaration, Component& object) {
  static NothingInside nothing;
  if (declaration.hold) declaration.hold(object, nothing);
}

void apply_parameters(const Declaration& declaration, Component& object,
                      const std::map<std::string, ParameterValue>& parameters,
                      const std::vector<ElementValue>& elements) {
  std::vector<std::string> errors;
  check_values("it", declaration.parameters, parameters, errors);
  check_elements("it", DeclaredElement(declaration), elements, errors);
  const auto fail = [&declaration](const std::string& why) {
    throw PluginError(title(declaration.kind, declaration.name) + ": " + why);
  };
  if (!errors.empty()) {
    fail(joined(errors, "; "));
  }
  // In the order of the declaration, whatever order they are given in.
  std::optional<std::string> problem;
  try {
    for (const ParameterDeclaration& parameter : declaration.parameters) {
      if (const auto given = parameters.find(parameter.name); given != parameters.end()) {
        parameter.set(object, given->second);
      }
    }
    set_elements(declaration, object, elements);
    object.configured();
  } catch (...) {
    problem = base::what_was_thrown();
  }
  if (problem) fail(*problem);
}

}  // namespace elsie::plugin
