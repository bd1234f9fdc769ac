// Faults of a declaration that do not make it unusable.
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "elsie/plugin/declaration_check.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/testing/checker.h"

namespace elsie::testing {
namespace {

class Findings {
 public:
  explicit Findings(const Declaration& declaration)
      : declaration_(declaration), found_(plugin::check_declaration(declaration)) {}

  std::vector<std::string> all() && {
    for (const ParameterDeclaration& parameter : declaration_.parameters) {
      check(parameter, "parameter '" + parameter.name + "'");
    }
    check(declaration_.elements);
    for (const PublishedNumber& number : declaration_.published) {
      require_meaning(number.facts.meaning, "published number '" + number.name + "'",
                      "give elsie::publishes() one");
    }
    for (const EventDeclaration& event : declaration_.events) {
      require_meaning(event.meaning, "event '" + event.name + "'", "give elsie::raises() one");
    }
    return std::move(found_);
  }

 private:
  void add(const std::string& finding) {
    found_.push_back(std::string(plugin::kind_name(declaration_.kind)) + " '" + declaration_.name +
                     "': " + finding);
  }

  void require_meaning(const std::string& meaning, const std::string& subject, const char* remedy) {
    if (meaning.find_first_not_of(' ') == std::string::npos) {
      add(subject + " has no meaning; " + remedy);
    }
  }

  void check(const std::vector<ElementDeclaration>& elements) {
    for (const ElementDeclaration& element : elements) {
      if (element.is_of_kind) continue;  // Elsie's own
      const std::string subject = "element '" + element.name + "'";
      require_meaning(element.meaning, subject, "give elsie::element() one");
      for (const ParameterDeclaration& parameter : element.parameters) {
        check(parameter, "parameter '" + parameter.name + "' of " + subject);
      }
      check(element.elements);
    }
  }

  void check(const ParameterDeclaration& parameter, const std::string& subject) {
    require_meaning(parameter.facts.meaning, subject, "say in a line what it is: .meaning");
    const ParameterFacts& facts = parameter.facts;
    const bool is_real =
        parameter.type == ParameterType::real || parameter.type == ParameterType::reals;
    const bool bounded =
        std::isfinite(facts.min) || std::isfinite(facts.above) || std::isfinite(facts.max);
    if (is_real && facts.unit.empty() && !bounded) {
      add(subject +
          " is a number without a unit and without bounds; give it its .unit, or, if it is "
          "a pure number, the range that makes sense");
    }
    if (!is_real && parameter.type != ParameterType::integer && !facts.unit.empty()) {
      add(subject + " has the unit '" + facts.unit + "', which only numbers may have");
    }
    if (is_real) {
      check_ending(parameter.name, facts.unit, subject);
    }
  }

  /// A unit as spelled in names: "deg/m" is deg_m or deg_per_m.
  static std::string in_a_name(const std::string& unit, const char* per) {
    std::string name;
    for (const char c : unit) {
      name += c == '/' ? per : std::isalnum(static_cast<unsigned char>(c)) ? std::string(1, c) : "";
    }
    return name;
  }

  /// A unit in a name must be the declared one.
  void check_ending(const std::string& name, const std::string& unit, const std::string& subject) {
    // Longer endings come first.
    static const std::array<std::pair<const char*, const char*>, 7> kEndings{{
        {"_rad_s", "rad/s"},
        {"_m_s", "m/s"},
        {"_deg", "deg"},
        {"_rad", "rad"},
        {"_px", "px"},
        {"_m", "m"},
        {"_s", "s"},
    }};
    if (!unit.empty() && (name.ends_with("_" + in_a_name(unit, "_")) ||
                          name.ends_with("_" + in_a_name(unit, "_per_")))) {
      return;  // turn_deg_m is in deg/m
    }
    for (const auto& [ending, expected] : kEndings) {
      if (name.ends_with(ending)) {
        if (unit != expected) {
          add(subject + " has the unit '" + unit + "', but its name says '" + expected + "'");
        }
        return;
      }
    }
  }

  const Declaration& declaration_;
  std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> check_declaration(const Declaration& declaration) {
  return Findings(declaration).all();
}

}  // namespace elsie::testing
