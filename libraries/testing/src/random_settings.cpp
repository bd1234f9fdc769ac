#include "random_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "text.h"

namespace elsie::testing {
namespace {

/// A number within the parameter's range; `usual` is its default.
double random_number(const ParameterDeclaration& parameter, double usual, Random& random) {
  const ParameterFacts& facts = parameter.facts;
  const bool open = facts.above >= facts.min && std::isfinite(facts.above);
  double low = std::max(open ? facts.above : facts.min, parameter.lowest);
  double high = std::min(facts.max, parameter.highest);
  // Without bounds, numbers as large as users would write.
  const double scale =
      (usual != 0.0 ? std::abs(usual) : 1.0) * std::pow(10.0, random.uniform(-2.0, 2.0));
  const bool bounded_below = low > -1e9, bounded_above = high < 1e9;
  if (!bounded_below) {
    low = (bounded_above ? high : usual) - scale;
  }
  if (!bounded_above) {
    high = (bounded_below ? low : usual) + scale;
  }
  double value = random.uniform(low, high);
  if (random.chance(0.2)) {
    value = high;
  } else if (random.chance(0.2)) {
    value = open ? std::nextafter(low, std::numeric_limits<double>::infinity()) : low;
  }
  if (parameter.type == ParameterType::integer) {
    value = std::clamp(std::round(value), std::ceil(low), std::floor(high));
    if (open && value <= low) {
      value += 1.0;
    }
  } else if (parameter.highest <= std::numeric_limits<float>::max() && open) {
    value =
        std::max(value, low + 1e-6 * std::max(1.0, std::abs(low)));  // the member may be a float
  }
  return value;
}

ParameterValue random_value(const ParameterDeclaration& parameter, Random& random) {
  switch (parameter.type) {
    case ParameterType::boolean:
      return random.chance(0.5);
    case ParameterType::integer: {
      const auto usual = static_cast<double>(std::get<std::int64_t>(parameter.default_value));
      return static_cast<std::int64_t>(random_number(parameter, usual, random));
    }
    case ParameterType::real:
      return random_number(parameter, std::get<double>(parameter.default_value), random);
    case ParameterType::reals: {
      std::vector<double> values(static_cast<std::size_t>(random.uniform(0, 9)));
      for (double& value : values) {
        value = random_number(parameter, 1.0, random);
      }
      return values;
    }
    case ParameterType::text: {
      const auto& choices = parameter.facts.choices;
      return choices.empty() ? parameter.default_value
                             : choices[static_cast<std::size_t>(
                                   random.uniform(0, static_cast<double>(choices.size())))];
    }
    case ParameterType::file:
      break;
  }
  return parameter.default_value;
}

std::string text(const ParameterValue& value) {
  if (const double* real = std::get_if<double>(&value)) {
    return number_text(*real);
  }
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    return std::to_string(*integer);
  }
  if (const bool* flag = std::get_if<bool>(&value)) {
    return *flag ? "true" : "false";
  }
  if (const auto* reals = std::get_if<std::vector<double>>(&value)) {
    std::string text = "(";
    for (const double real : *reals) {
      text += (text.size() > 1 ? " " : "") + number_text(real);
    }
    return text + ")";
  }
  return std::get<std::string>(value);
}

}  // namespace

Settings random_settings(const Declaration& declaration, const Settings& fixed, Random& random) {
  Settings settings = fixed;
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    const bool keep = parameter.type == ParameterType::file ||
                      (parameter.type == ParameterType::text && parameter.facts.choices.empty());
    if (random.chance(0.5) && !keep && !fixed.contains(parameter.name)) {
      settings.emplace(parameter.name, random_value(parameter, random));
    }
  }
  return settings;
}

std::string in_words(const Settings& settings) {
  std::string words;
  for (const auto& [name, value] : settings) {
    words += (words.empty() ? "" : ", ") + name + " = " + text(value);
  }
  return words.empty() ? "its defaults" : words;
}

}  // namespace elsie::testing
