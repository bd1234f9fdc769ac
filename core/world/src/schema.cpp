#include "elsie/world/schema.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/vocabulary.h"

#include "markup.h"
#include "values.h"

namespace elsie::world {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<double>::max();

std::string number(double value) { return format_value(ParameterValue(value)); }

std::string indented(const std::string& text, std::size_t depth) {
  return std::string(2 * depth, ' ') + text + "\n";
}

std::string documentation(const std::string& text, std::size_t depth) {
  return indented(
      "<xs:annotation><xs:documentation>" + escaped(text) + "</xs:documentation></xs:annotation>",
      depth);
}

std::string facet(const std::string& name, const std::string& value) {
  return "<xs:" + name + " value=\"" + escaped(value) + "\"/>";
}

std::string restriction(const std::string& base, const std::string& facets) {
  return "<xs:restriction base=\"" + base + "\">" + facets + "</xs:restriction>";
}

// The types that the facets of every attribute start from: stricter than XML Schema's own, which
// take NaN, INF, a leading "+", and 1 for true.
std::string basic_types() {
  const auto type = [](const std::string& name, const std::string& content) {
    return indented("<xs:simpleType name=\"" + name + "\">" + content + "</xs:simpleType>", 1);
  };
  const std::string digits = "-?([0-9]+(\\.[0-9]*)?|\\.[0-9]+)([eE][+\\-]?[0-9]+)?";
  return type("number", restriction("xs:double", facet("pattern", digits) +
                                                     facet("minInclusive", number(-kLargest)) +
                                                     facet("maxInclusive", number(kLargest)))) +
         type("whole_number", restriction("xs:long", facet("pattern", "-?[0-9]+"))) +
         type("truth", restriction("xs:string",
                                   facet("enumeration", "true") + facet("enumeration", "false"))) +
         type("name", restriction("xs:string", facet("pattern", "[A-Za-z_][A-Za-z0-9_.\\-]*"))) +
         type("colour", restriction("xs:string", facet("pattern", "#[0-9a-fA-F]{6}")));
}

std::string range_facets(const Field& field) {
  const ParameterFacts& facts = field.facts;
  const double low = std::max(facts.min, field.lowest);
  const double high = std::min(facts.max, field.highest);
  std::string range;
  if (facts.above > -kInfinity && facts.above >= low) {
    range += facet("minExclusive", number(facts.above));
  } else if (low > -kInfinity) {
    range += facet("minInclusive", number(low));
  }
  return high < kInfinity ? range + facet("maxInclusive", number(high)) : range;
}

// The same for whole numbers, whose bounds must be whole: a bound between two of them says the same
// as the next one inside. Beyond 9e18 lies what no number here can be.
std::string whole_facets(const Field& field) {
  const auto whole = [](double bound) {
    return format_value(ParameterValue(static_cast<std::int64_t>(bound)));
  };
  const ParameterFacts& facts = field.facts;
  const double low = std::max({std::ceil(facts.min), std::floor(facts.above) + 1, field.lowest});
  const double high = std::min(std::floor(facts.max), field.highest);
  return (low > -9e18 ? facet("minInclusive", whole(low)) : "") +
         (high < 9e18 ? facet("maxInclusive", whole(high)) : "");
}

// The content of a simpleType.
std::string value_type(const Field& field) {
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
  return restriction(field.form == TextForm::id       ? "name"
                     : field.form == TextForm::colour ? "colour"
                                                      : "xs:string",
                     choices);
}

std::string attribute(const Field& field) {
  std::string about = field.facts.meaning;
  if (!field.facts.unit.empty()) {
    about += " (" + field.facts.unit + ")";
  }
  if (field.default_value && !format_value(*field.default_value).empty()) {
    about += "; default " + format_value(*field.default_value);
  }
  return indented("<xs:attribute name=\"" + field.name + "\"" +
                      (field.required ? " use=\"required\"" : "") + ">",
                  2) +
         documentation(about, 3) +
         indented("<xs:simpleType>" + value_type(field) + "</xs:simpleType>", 3) +
         indented("</xs:attribute>", 2);
}

class Schema {
 public:
  explicit Schema(const plugin::Host& host) : host_(host) {}

  std::string text() {
    std::string roots =
        element("world", type_of(vocabulary()), vocabulary().meaning, world_constraints(), 1) +
        element("robot_template", type_of(template_vocabulary()), template_vocabulary().meaning,
                robot_constraints("template"), 1);
    std::string all =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n" +
        documentation("World files of Elsie, format " + std::to_string(kFormat) +
                          ", with the plugins that were found",
                      1) +
        roots + basic_types();
    for (const std::string& name : order_) {
      all += types_.at(name);
    }
    return all + "</xs:schema>\n";
  }

 private:
  static std::string element(const std::string& name, const std::string& type,
                             const std::string& meaning, const std::string& constraints,
                             std::size_t depth, const std::string& occurs = "") {
    return indented("<xs:element name=\"" + name + "\" type=\"" + type + "\"" + occurs + ">",
                    depth) +
           documentation(meaning, depth + 1) + constraints + indented("</xs:element>", depth);
  }

  static std::string constraint(const std::string& kind, const std::string& name,
                                const std::string& selector, const std::string& field) {
    return "<xs:" + kind + " name=\"" + name + "\"" +
           (kind == "keyref" ? " refer=\"robot_id\"" : "") + "><xs:selector xpath=\"" + selector +
           "\"/><xs:field xpath=\"@" + field + "\"/></xs:" + kind + ">\n";
  }

  static std::string world_constraints() {
    std::string text = constraint("key", "robot_id", "robots/robot", "id") +
                       constraint("unique", "box_id", "obstacles/*|resources/*", "id") +
                       constraint("unique", "charger_id", "chargers/charger", "id") +
                       constraint("unique", "team_id", "teams/team", "id");
    // References to robots. Teams and boxes may be there without being named in the file.
    for (const ElementSpec& group : vocabulary().children) {
      for (const ElementSpec& member : group.children) {
        for (const AttributeSpec& field : member.attributes) {
          if (field.refers_to == Reference::robot) {
            text += constraint("keyref", group.name + "." + member.name + "." + field.name,
                               group.name + "/" + member.name, field.name);
          }
        }
      }
    }
    return text;
  }

  static std::string robot_constraints(const std::string& where) {
    return constraint("unique", where + ".segment_id", "segments/segment", "id") +
           constraint("unique", where + ".sensor_id", "sensors/*", "id") +
           behavior_constraint(where);
  }

  static std::string behavior_constraint(const std::string& where) {
    return constraint("unique", where + ".behavior_id", "behaviors/*", "id");
  }

  // Defines the type of an element, and of all below it; returns its name.
  std::string type_of(const ElementSpec& spec) {
    return define(spec.name, [&] { return content(spec); },
                  {spec.attributes.begin(), spec.attributes.end()});
  }

  // A type may hold itself: its name is known before its content is.
  std::string define(const std::string& name, const std::function<std::string()>& content,
                     const std::vector<Field>& fields) {
    const std::string type = name + ".type";
    if (!types_.contains(type)) {
      types_[type] = "";
      std::string text = indented("<xs:complexType name=\"" + type + "\">", 1) + content();
      for (const Field& field : fields) {
        text += attribute(field);
      }
      types_[type] = text + indented("</xs:complexType>", 1);
      order_.push_back(type);
    }
    return type;
  }

  std::string content(const ElementSpec& spec) {
    std::string elements;
    bool many = false;
    for (const ElementSpec& child : spec.children) {
      many |= child.at_most > 1;
      elements += child.plugins ? plugin_elements(child) : child_element(spec, child);
    }
    if (elements.empty()) {
      return "";
    }
    // In a group any number in any order; otherwise each once in any order, or a plain list.
    const bool once = spec.group && !many;
    const std::string model = spec.group ? "choice" : many ? "sequence" : "all";
    const std::string occurs = !spec.group ? ""
                               : once      ? " minOccurs=\"0\""
                                           : " minOccurs=\"0\" maxOccurs=\"unbounded\"";
    return indented("<xs:" + model + occurs + ">", 2) + elements +
           indented("</xs:" + model + ">", 2);
  }

  std::string child_element(const ElementSpec& parent, const ElementSpec& child) {
    std::string occurs;
    if (!parent.group) {
      occurs = " minOccurs=\"" + std::to_string(child.at_least) + "\"";
      occurs += child.at_most > 1 ? " maxOccurs=\"unbounded\"" : "";
    }
    return element(child.name, type_of(child), child.meaning,
                   child.name == "robot" ? robot_constraints("robot") : "", 3, occurs);
  }

  std::string plugin_elements(const ElementSpec& spec) {
    std::string elements;
    for (const Declaration* declaration : host_.all(*spec.plugins)) {
      const std::string name =
          std::string(plugin::kind_name(*spec.plugins)) + "." + declaration->name;
      std::vector<Field> fields(spec.attributes.begin(), spec.attributes.end());
      for (const ParameterDeclaration& parameter : declaration->parameters) {
        if (!spec.attribute(parameter.name)) {  // the reader refuses such a plugin
          fields.push_back(field_of(parameter));
          fields.back().required = false;  // a template may give it
        }
      }
      const std::string type = define(
          name, [&] { return inside(name, *declaration); }, fields);
      elements += element(declaration->name, type, declaration->description,
                          declaration->hold ? behavior_constraint(name) : "", 3);
    }
    return elements;
  }

  // The content of a plugin's element: what it declares, any number in any order, and with that, if
  // it holds others, <behaviors> and <coordinator>, each once.
  std::string inside(const std::string& name, const Declaration& declaration) {
    const std::string declared = declared_elements(name, declaration);
    if (!declaration.hold) {
      return declared.empty() ? "" : sequence(declared);
    }
    std::vector<std::string> groups;
    for (const ElementSpec& group : coordination_vocabulary().children) {
      groups.push_back(element(group.name, type_of(group), group.meaning, "", 3));
    }
    // Written so that the next element alone always tells where in the model it stands.
    const auto first = [&](const std::string& one, const std::string& other) {
      return sequence(one + declared + sequence(other + declared, " minOccurs=\"0\""));
    };
    return sequence(declared + indented("<xs:choice minOccurs=\"0\">", 2) +
                    first(groups[0], groups[1]) + first(groups[1], groups[0]) +
                    indented("</xs:choice>", 2));
  }

  static std::string sequence(const std::string& content, const std::string& occurs = "") {
    return indented("<xs:sequence" + occurs + ">", 2) + content + indented("</xs:sequence>", 2);
  }

  // Refers to a group of the elements that a plugin declares, which is defined here.
  std::string declared_elements(const std::string& name, const Declaration& declaration) {
    if (declaration.elements.empty()) {
      return "";
    }
    std::string elements;
    for (const ElementDeclaration& declared : declaration.elements) {
      std::vector<Field> fields;
      for (const ParameterDeclaration& parameter : declared.parameters) {
        fields.push_back(field_of(parameter));
      }
      const std::string type = define(
          name + "." + declared.name, [] { return std::string(); }, fields);
      elements += element(declared.name, type, declared.meaning, "", 3);
    }
    const std::string group = name + ".elements";
    types_[group] = indented("<xs:group name=\"" + group + "\">", 1) + indented("<xs:choice>", 2) +
                    elements + indented("</xs:choice>", 2) + indented("</xs:group>", 1);
    order_.push_back(group);
    return indented("<xs:group ref=\"" + group + "\" minOccurs=\"0\" maxOccurs=\"unbounded\"/>", 3);
  }

  const plugin::Host& host_;
  std::map<std::string, std::string> types_;  // and groups, by name
  std::vector<std::string> order_;
};

}  // namespace

std::string world_schema(const plugin::Host& host) { return Schema(host).text(); }

}  // namespace elsie::world
