#include "elsie/plugin/declaration_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include "elsie/api/simulator_events.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/kind_name.h"

#include "text.h"

namespace elsie::plugin {
namespace {

bool is_plain_name(std::string_view name) {
  const auto is_small_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return !name.empty() && is_small_letter(name.front()) &&
         std::all_of(name.begin(), name.end(), [&](char c) {
           return is_small_letter(c) || (c >= '0' && c <= '9') || c == '_';
         });
}

/// Collects the faults of one declaration.
class Checker {
 public:
  explicit Checker(const Declaration& declaration) : declaration_(declaration) {}

  std::vector<std::string> faults() && {
    check_plugin();
    for (const ParameterDeclaration& parameter : declaration_.parameters) {
      check_parameter(parameter);
    }
    check_field_parameters();
    check_event_parameters();
    check_elements();
    check_readings();
    for (const EventDeclaration& event : declaration_.events) {
      check_name("event", event.name);
      if (events::find(event.name)) {
        fault("event '" + event.name +
              "' is one that the simulator raises; give the plugin's event another name");
      }
    }
    for (const std::string& event : declaration_.reacts_to) {
      const events::Facts* const facts = events::find(event);
      if (facts && !facts->is_perceived) {
        fault("it reacts to the event '" + event + "', which plugins do not perceive");
      }
    }
    check_unique("parameter", declaration_.parameters, &ParameterDeclaration::name);
    check_unique("element", declaration_.elements, &ElementDeclaration::name);
    check_unique("event", declaration_.events, &EventDeclaration::name);
    check_unique("needed reading", declaration_.needs, &ReadingDeclaration::kind);
    for (const PublishedNumber& number : declaration_.published) {
      check_name("published number", number.name);
      if (!number.get) fault("published number '" + number.name + "' is not bound to a member");
    }
    check_unique("published number", declaration_.published, &PublishedNumber::name);
    return std::move(faults_);
  }

 private:
  void fault(const std::string& text) {
    faults_.push_back(title(declaration_.kind, declaration_.name) + ": " + text);
  }

  void check_name(const char* what, const std::string& name) {
    if (!is_plain_name(name)) {
      fault("the name of " + std::string(what) + " '" + name +
            "' must be a small letter followed by small letters, digits and underscores");
    }
  }

  template <class Item>
  void check_unique(const char* what, const std::vector<Item>& items, std::string Item::*name) {
    std::set<std::string> seen;
    for (const Item& item : items) {
      if (!seen.insert(item.*name).second) {
        fault(std::string(what) + " '" + item.*name + "' is declared twice" +
              (what == std::string_view("element") && declaration_.kind == PluginKind::sensor
                   ? "; every sensor has <noise> and <failure>"
                   : ""));
      }
    }
  }

  void check_plugin() {
    if (std::find(kPluginKinds.begin(), kPluginKinds.end(), declaration_.kind) ==
        kPluginKinds.end()) {
      fault(
          "it is neither a sensor nor a behavior nor a coordinator nor a measure nor a rule nor a "
          "drive nor a localisation nor an actuator");
    }
    check_name("the plugin", declaration_.name);
    if (declaration_.version.empty()) fault("its version is empty");
    if (declaration_.description.empty()) fault("it has no description");
    if (!declaration_.create) fault("it has no function that makes an object");
  }

  void check_elements() {
    for (const ElementDeclaration& element : declaration_.elements) {
      if (!element.clear || !element.append) {
        fault("element '" + element.name + "' is not bound to a list");
      }
    }
    check_elements(declaration_.elements);
    check_defaults(DeclaredElement(declaration_), declaration_.default_elements);
    if (declaration_.hold && declaration_.kind != PluginKind::behavior) {
      fault("it holds behaviors, which only a behavior may");
    }
  }

  void check_elements(const std::vector<ElementDeclaration>& elements) {
    for (const ElementDeclaration& element : elements) {
      check_name("element", element.name);
      if (element.name == "behaviors" || element.name == "coordinator") {
        fault("element '" + element.name + "' has a name that is reserved for nested behaviors");
      }
      for (const ParameterDeclaration& parameter : element.parameters) {
        check_value_of(parameter);
      }
      check_unique("parameter", element.parameters, &ParameterDeclaration::name);
      check_unique("element", element.elements, &ElementDeclaration::name);
      check_elements(element.elements);
    }
  }

  void check_defaults(const DeclaredElement& around, const std::vector<ElementValue>& values) {
    for (const ElementValue& value : values) {
      // An unknown name is reported elsewhere.
      if (const auto element = around.inside(value.element)) check_default(*element, value);
    }
  }
  /// Checks an element of a default list.
  void check_default(const DeclaredElement& element, const ElementValue& value) {
    for (const ParameterDeclaration& parameter : element.parameters()) {
      const auto given = value.parameters.find(parameter.name);
      if (given == value.parameters.end()) continue;
      if (const auto wrong = check_value(parameter, given->second)) {
        fault("in the default list of elements '" + value.element + "' " + *wrong);
      } else if (parameter.type == ParameterType::file &&
                 !std::get<std::string>(given->second).empty()) {
        // Only files of elements in the world are searched for.
        fault("the default list of elements '" + value.element + "' names the file '" +
              std::get<std::string>(given->second) + "', which is not searched for");
      }
    }
    check_defaults(element, value.elements);
  }

  void check_parameter(const ParameterDeclaration& parameter) {
    check_value_of(parameter);
    if (!parameter.set || !parameter.get) {
      fault("parameter '" + parameter.name + "' is not bound to a member");
    }
  }

  void check_value_of(const ParameterDeclaration& parameter) {
    const ParameterFacts& facts = parameter.facts;
    check_name("parameter", parameter.name);
    const std::string subject = "parameter '" + parameter.name + "' ";
    if (std::isnan(facts.min) || std::isnan(facts.above) || std::isnan(facts.max) ||
        facts.min > facts.max || facts.above >= facts.max) {
      fault(subject + "has an empty range");
      return;
    }
    if (!facts.choices.empty() && parameter.type != ParameterType::text) {
      fault(subject + "has choices, which only a text may have");
    }
    const bool has_range =
        std::isfinite(facts.min) || std::isfinite(facts.above) || std::isfinite(facts.max);
    if (has_range &&
        (parameter.type == ParameterType::text || parameter.type == ParameterType::file ||
         parameter.type == ParameterType::boolean)) {
      fault(subject + "has a range, which only numbers may have");
    }
    if (const auto wrong = check_value(parameter, parameter.default_value)) {
      fault("the default of " + *wrong);
    }
  }

  void check_field_parameters() {
    for (const std::string& name : declaration_.field_parameters) {
      const auto* const parameter = find_declared(declaration_.parameters, name);
      if (!parameter || parameter->type != ParameterType::text || parameter->facts.live) {
        fault("names_field(\"" + name + "\") needs a parameter of that name, a text that is not " +
              "live");
      }
    }
    if (!declaration_.field_parameters.empty() && declaration_.kind != PluginKind::sensor &&
        declaration_.kind != PluginKind::actuator) {
      fault("only sensors and actuators use fields, so it names none");
    }
  }

  void check_event_parameters() {
    for (const std::string& path : declaration_.event_parameters) {
      const std::size_t slash = path.find('/');
      const auto is_text = [](const std::vector<ParameterDeclaration>& among,
                              const std::string& name) {
        const auto* const parameter = find_declared(among, name);
        return parameter && parameter->type == ParameterType::text;
      };
      const std::function<bool(const std::vector<ElementDeclaration>&)> has_text =
          [&](const std::vector<ElementDeclaration>& among) {
            return std::any_of(among.begin(), among.end(), [&](const ElementDeclaration& each) {
              return (each.name == path.substr(0, slash) &&
                      is_text(each.parameters, path.substr(slash + 1))) ||
                     has_text(each.elements);
            });
          };
      if (slash == std::string::npos ? !is_text(declaration_.parameters, path)
                                     : !has_text(declaration_.elements)) {
        fault("names_event(\"" + path + "\") needs a text parameter of that name");
      }
    }
    const PluginKind kind = declaration_.kind;
    if (!declaration_.event_parameters.empty() && kind != PluginKind::behavior &&
        kind != PluginKind::coordinator && kind != PluginKind::rule) {
      fault("only behaviors, coordinators and rules perceive events, so it names none");
    }
  }

  void check_reading(const ReadingDeclaration& reading, bool is_produced) {
    check_name("reading", reading.kind);
    const std::string subject = "reading '" + reading.kind + "' ";
    if (reading.size == 0 && (reading.lists_fields || is_produced)) {
      return fault(subject + "has no size");
    }
    static const std::array kOwn{ReadingDeclaration::of<RangeReading>(),
                                 ReadingDeclaration::of<ProximityReading>(),
                                 ReadingDeclaration::of<VisionReading>()};
    for (const ReadingDeclaration& own : kOwn) {
      if (own.kind == reading.kind && !own.fits(reading)) {
        fault(subject + "has another layout than Elsie's reading of that name; include " +
              "elsie/api/reading.h for that one, or give your own another name");
      }
    }
    if (reading.lists_fields && reading.fields.empty()) {
      fault(subject + "lists nothing in visit() when it is new; every reading must list the same " +
            "names");
    }
    std::set<std::string> paths;
    for (const FieldDeclaration& field : reading.fields) {
      check_name("listed field", field.name);
      if (!field.group.empty()) check_name("listed list", field.group);
      if (const std::string path = field.path(); !paths.insert(path).second) {
        fault(subject + "lists " + base::name_in_quotes(path) + " twice in visit()");
      }
    }
  }

  void check_readings() {
    for (const ReadingDeclaration& needed : declaration_.needs) check_reading(needed, false);
    for (const ReadingDeclaration& made : declaration_.produces) check_reading(made, true);
    const PluginKind kind = declaration_.kind;
    const bool is_sensor = kind == PluginKind::sensor;
    const std::size_t produced = declaration_.produces.size();
    if (is_sensor && produced != 1) {
      fault("a sensor must produce one kind of reading, not " + std::to_string(produced));
    }
    if (!is_sensor && produced != 0) fault("only a sensor produces readings");
    const bool perceives = kind == PluginKind::behavior || kind == PluginKind::coordinator;
    const bool is_known =
        std::find(kPluginKinds.begin(), kPluginKinds.end(), kind) != kPluginKinds.end();
    if (is_known && !perceives && !declaration_.needs.empty()) {
      fault("a " + std::string(kind_name(kind)) + " is not given readings, so it cannot need any");
    }
    if (kind == PluginKind::measure && !declaration_.events.empty()) {
      fault("a measure only watches, so it raises no events");
    }
    if (kind == PluginKind::drive && !declaration_.events.empty()) {
      fault("a drive only carries out motions, so it raises no events");
    }
    if (kind == PluginKind::localisation && !declaration_.events.empty()) {
      fault("a localisation only estimates, so it raises no events");
    }
    if (!declaration_.reacts_to.empty() && !perceives) {
      fault("only behaviors and coordinators perceive events, so it reacts to none");
    }
  }

  const Declaration& declaration_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> check_declaration(const Declaration& declaration) {
  return Checker(declaration).faults();
}

std::vector<std::string> check_declarations(std::span<const Declaration> declarations) {
  std::vector<std::string> faults;
  std::set<std::pair<PluginKind, std::string>> seen;
  for (const Declaration& declaration : declarations) {
    std::vector<std::string> more = check_declaration(declaration);
    faults.insert(faults.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
    if (!seen.emplace(declaration.kind, declaration.name).second) {
      faults.push_back(title(declaration.kind, declaration.name) + " is declared twice");
    }
  }
  return faults;
}

}  // namespace elsie::plugin
