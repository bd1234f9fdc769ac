#include "schema_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "elsie/world/escaped.h"
#include "elsie/world/values.h"

namespace elsie::reference {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

std::string value_text(double value) { return world::format_value(ParameterValue(value)); }

std::string facet(const std::string& name, const std::string& value) {
  return "<xs:" + name + " value=\"" + world::escaped_attribute(value) + "\"/>";
}

std::string restriction(const std::string& base, const std::string& facets) {
  return "<xs:restriction base=\"" + base + "\">" + facets + "</xs:restriction>";
}

std::string range_facets(const world::Field& field) {
  const ParameterFacts& facts = field.facts;
  const double low = std::max(facts.min, field.lowest);
  const double high = std::min(facts.max, field.highest);
  std::string range;
  if (facts.above > -kInfinity && facts.above >= low) {
    range += facet("minExclusive", value_text(facts.above));
  } else if (low > -kInfinity) {
    range += facet("minInclusive", value_text(low));
  }
  return high < kInfinity ? range + facet("maxInclusive", value_text(high)) : range;
}

// The same for whole numbers, whose bounds must be whole: a bound between two of them equals the
// next one inside. No number here exceeds 9e18.
std::string whole_facets(const world::Field& field) {
  const auto whole = [](double bound) {
    return world::format_value(ParameterValue(static_cast<std::int64_t>(bound)));
  };
  const ParameterFacts& facts = field.facts;
  const double low = std::max({std::ceil(facts.min), std::floor(facts.above) + 1, field.lowest});
  const double high = std::min(std::floor(facts.max), field.highest);
  return (low > -9e18 ? facet("minInclusive", whole(low)) : "") +
         (high < 9e18 ? facet("maxInclusive", whole(high)) : "");
}

// The content of a simpleType.
std::string value_type(const world::Field& field) {
  switch (field.type) {
    case ParameterType::real:
      return restriction("number", range_facets(field));
    case ParameterType::integer:
      return restriction("whole_number", whole_facets(field));
    case ParameterType::boolean:
      return restriction("truth", "");
    case ParameterType::reals:
      return "<xs:list><xs:simpleType>" + restriction("number", range_facets(field)) +
             "</xs:simpleType></xs:list>";
    case ParameterType::text:
    case ParameterType::file:
      break;
  }
  std::string choices;
  for (const std::string& choice : field.facts.choices) {
    choices += facet("enumeration", choice);
  }
  return restriction(field.form == world::TextForm::id       ? "name"
                     : field.form == world::TextForm::colour ? "colour"
                                                             : "xs:string",
                     choices);
}

}  // namespace

std::string indented(const std::string& text, std::size_t depth) {
  return std::string(2 * depth, ' ') + text + "\n";
}

std::string documentation(const std::string& text, std::size_t depth) {
  return indented("<xs:annotation><xs:documentation>" + world::escaped_attribute(text) +
                      "</xs:documentation></xs:annotation>",
                  depth);
}

std::string basic_types() {
  const auto type = [](const std::string& name, const std::string& content) {
    return indented("<xs:simpleType name=\"" + name + "\">" + content + "</xs:simpleType>", 1);
  };
  const std::string digits = "-?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";
  return type("number", restriction("xs:double", facet("pattern", digits) +
                                                     facet("minInclusive", value_text(-kLargest)) +
                                                     facet("maxInclusive", value_text(kLargest)))) +
         type("whole_number", restriction("xs:long", facet("pattern", "-?[0-9]+"))) +
         type("truth", restriction("xs:string",
                                   facet("enumeration", "true") + facet("enumeration", "false"))) +
         type("name", restriction("xs:string", facet("pattern", "[A-Za-z_][A-Za-z0-9_.\\-]*"))) +
         type("colour", restriction("xs:string", facet("pattern", "#[0-9a-fA-F]{6}")));
}

std::string schema_attribute(const world::Field& field) {
  std::string about = field.facts.meaning;
  if (!field.facts.unit.empty()) {
    about += " (" + field.facts.unit + ")";
  }
  if (field.default_value && !world::format_value(*field.default_value).empty()) {
    about += "; default " + world::format_value(*field.default_value);
  }
  return indented("<xs:attribute name=\"" + field.name + "\"" +
                      (field.required ? " use=\"required\"" : "") + ">",
                  2) +
         documentation(about, 3) +
         indented("<xs:simpleType>" + value_type(field) + "</xs:simpleType>", 3) +
         indented("</xs:attribute>", 2);
}

}  // namespace elsie::reference
