#include "elsie/plugin/parameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string_view>
#include <variant>
#include <vector>

#include "elsie/api/behavior.h"
#include "elsie/base/near_name.h"
#include "elsie/base/thrown.h"
#include "elsie/base/words.h"
#include "elsie/plugin/error.h"

#include "text.h"

namespace elsie::plugin {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

bool in_range(const ParameterFacts& facts, double value) {
  return value >= facts.min && value > facts.above && value <= facts.max;
}

/// Returns whether the member can hold the number.
bool is_holdable(const ParameterDeclaration& parameter, double value) {
  return value >= parameter.lowest && value <= parameter.highest;
}

/// The numbers of a value, if it has any.
std::vector<double> numbers_of(const ParameterValue& value) {
  if (const auto* const real = std::get_if<double>(&value)) {
    return {*real};
  }
  if (const auto* const whole = std::get_if<std::int64_t>(&value)) {
    return {static_cast<double>(*whole)};
  }
  const auto* const list = std::get_if<std::vector<double>>(&value);
  return list ? *list : std::vector<double>();
}

bool is_allowed(const ParameterDeclaration& parameter, const ParameterValue& value) {
  const auto& choices = parameter.facts.choices;
  if (parameter.type == ParameterType::text && !choices.empty()) {
    return std::find(choices.begin(), choices.end(), std::get<std::string>(value)) != choices.end();
  }
  const std::vector<double> numbers = numbers_of(value);
  return std::all_of(numbers.begin(), numbers.end(), [&](double number) {
    return std::isfinite(number) && in_range(parameter.facts, number) &&
           is_holdable(parameter, number);
  });
}

/// "above 0", "at most 50".
std::vector<std::string> limit_texts(const ParameterDeclaration& parameter) {
  const ParameterFacts& facts = parameter.facts;
  // Limits of the member's type are not mentioned, except that it has no sign.
  const double min = parameter.lowest == 0.0 ? std::max(facts.min, 0.0) : facts.min;
  std::vector<std::string> limits;
  if (facts.above > -kInfinity && facts.above >= min) {
    limits.push_back("above " + number_text(facts.above));
  } else if (min > -kInfinity) {
    limits.push_back("at least " + number_text(min));
  }
  if (facts.max < kInfinity) limits.push_back("at most " + number_text(facts.max));
  return limits;
}

/// Why numbers are refused, if allowed_values() does not explain it.
std::string refusal_of(const ParameterDeclaration& parameter, const ParameterValue& value) {
  const std::vector<double> numbers = numbers_of(value);
  const bool is_list = parameter.type == ParameterType::reals;
  if (!std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); })) {
    return is_list ? ", of which not every number is finite" : ", which is not finite";
  }
  if (!is_list && !numbers.empty() && in_range(parameter.facts, numbers.front()) &&
      !is_holdable(parameter, numbers.front())) {
    return ", which does not fit its type in the plugin (" + number_text(parameter.lowest) +
           " to " + number_text(parameter.highest) + ")";
  }
  return "";
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

std::string allowed_values(const ParameterDeclaration& parameter) {
  const std::vector<std::string>& choices = parameter.facts.choices;
  if (parameter.type == ParameterType::text && !choices.empty()) {
    std::vector<std::string> names;
    std::transform(choices.begin(), choices.end(), std::back_inserter(names), name_in_quotes);
    return (names.size() == 1 ? "" : "one of ") + joined(names, ", ");
  }
  const Type type = facts_of(parameter.type);
  std::string text = type.words;
  if (!type.is_number) return text;
  const std::vector<std::string> limits = limit_texts(parameter);
  const std::string& unit = parameter.facts.unit;
  if (!limits.empty()) {
    text += (parameter.type == ParameterType::reals ? ", each " : " ") + base::enumerated(limits);
    text += unit.empty() ? "" : " " + unit;
  } else if (!unit.empty()) {
    text += " in " + unit;
  }
  return text;
}

std::optional<std::string> check_value(const ParameterDeclaration& parameter,
                                       const ParameterValue& value) {
  const bool right_type = value.index() == facts_of(parameter.type).alternative;
  if (right_type && is_allowed(parameter, value)) return std::nullopt;
  std::string sentence = parameter.name + " is " + value_text(value);
  if (right_type) sentence += refusal_of(parameter, value);
  sentence += ", but must be " + allowed_values(parameter);
  if (const auto* const text = std::get_if<std::string>(&value);
      right_type && text && parameter.facts.choices.size() > 1) {
    sentence += base::did_you_mean(*text, parameter.facts.choices);
  }
  return sentence;
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
  for (const ElementValue& element : elements) {
    if (const auto* known = find_declared(declaration.elements, element.element)) {
      check_values("<" + element.element + ">", known->parameters, element.parameters, errors);
    } else {
      errors.push_back("it has no element <" + element.element + ">" +
                       did_you_mean(element.element, declaration.elements));
    }
  }
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
