#include "elsie/reference/schema.h"

#include <algorithm>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/vocabulary.h"

#include "schema_text.h"

namespace elsie::reference {

namespace {

class Schema {
 public:
  explicit Schema(const plugin::Host& host) : host_(host) {}

  std::string of_worlds() {
    const std::string roots =
        element("world", type_of(world::vocabulary()), world::vocabulary().meaning,
                world_constraints(), 1) +
        element("robot_template", type_of(world::template_vocabulary()),
                world::template_vocabulary().meaning, robot_constraints("template"), 1);
    return text("World files of Elsie, format " + std::to_string(world::kFormat), roots);
  }

  std::string of(const world::ElementSpec& root, const std::string& about) {
    own_ = root.name + ".";
    return text(about, element(root.name, type_of(root), root.meaning, unique(root), 1));
  }

 private:
  std::string text(const std::string& about, const std::string& roots) const {
    std::string all =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<xs:schema xmlns:xs=\"http://www.w3.org/2001/XMLSchema\">\n" +
        documentation(about + ", with the plugins that were found", 1) + roots + basic_types();
    for (const std::string& name : order_) {
      all += types_.at(name);
    }
    return all + "</xs:schema>\n";
  }

  static std::string element(const std::string& name, const std::string& type,
                             const std::string& meaning, const std::string& constraints,
                             std::size_t depth, const std::string& occurs = "") {
    return indented("<xs:element name=\"" + name + "\" type=\"" + type + "\"" + occurs + ">",
                    depth) +
           documentation(meaning, depth + 1) + constraints + indented("</xs:element>", depth);
  }

  static std::string constraint(const std::string& kind, const std::string& name,
                                const std::string& selector, const std::string& field) {
    return "<xs:" + kind + " name=\"" + name + "\"><xs:selector xpath=\"" + selector +
           "\"/><xs:field xpath=\"@" + field + "\"/></xs:" + kind + ">\n";
  }

  // Of references nothing is said: teams, boxes and robots may exist without being in the file.
  static std::string world_constraints() {
    return constraint("key", "robot_id", "robots/robot", "id") +
           constraint("unique", "box_id", "obstacles/*|resources/*", "id") +
           constraint("unique", "charger_id", "chargers/charger", "id") +
           constraint("unique", "nest_id", "nests/nest", "id") +
           constraint("unique", "lamp_id", "lamps/lamp", "id") +
           constraint("unique", "patch_id", "patches/*", "id") +
           constraint("unique", "field_id", "fields/field", "id") +
           constraint("unique", "measure_id", "measures/*|rules/*", "id") +
           constraint("unique", "team_id", "teams/team", "id");
  }

  static std::string robot_constraints(const std::string& where) {
    return constraint("unique", where + ".segment_id", "segments/segment", "id") +
           constraint("unique", where + ".sensor_id", "sensors/*", "id") +
           constraint("unique", where + ".actuator_id", "actuators/*", "id") +
           behavior_constraint(where);
  }

  static std::string behavior_constraint(const std::string& where) {
    return constraint("unique", where + ".behavior_id", "behaviors/*", "id");
  }

  std::string unique(const world::ElementSpec& spec) const {
    std::string text;
    for (const world::ElementSpec::Unique& each : spec.unique) {
      std::string name = own_ + spec.name + "." + each.elements + "." + each.attribute;
      std::replace(name.begin(), name.end(), '/', '.');
      text += constraint("unique", name, each.elements, each.attribute);
    }
    return text;
  }

  // Defines the type of an element and of all elements inside; returns its name.
  std::string type_of(const world::ElementSpec& spec) {
    return define(own_ + spec.name, [&] { return content(spec); },
                  {spec.attributes.begin(), spec.attributes.end()});
  }

  // A type may contain itself: its name is known before its content.
  std::string define(const std::string& name, const std::function<std::string()>& content,
                     const std::vector<world::Field>& fields) {
    const std::string type = name + ".type";
    if (!types_.contains(type)) {
      types_[type] = "";
      std::string text = indented("<xs:complexType name=\"" + type + "\">", 1) + content();
      for (const world::Field& field : fields) {
        text += schema_attribute(field);
      }
      types_[type] = text + indented("</xs:complexType>", 1);
      order_.push_back(type);
    }
    return type;
  }

  static bool is_choice(const world::ElementSpec& spec) {
    return spec.group || spec.take ||
           (spec.held().size() > 1 &&
            std::any_of(spec.held().begin(), spec.held().end(),
                        [](const world::ElementSpec& child) { return child.at_most > 1; }));
  }

  std::string content(const world::ElementSpec& spec) {
    std::string elements;
    bool many = false;
    for (const world::ElementSpec& child : spec.held()) {
      many |= child.at_most > 1;
      elements += child.plugins ? plugin_elements(child) : child_element(spec, child);
    }
    if (spec.take) {
      const std::string any = indented("<xs:group ref=\"" + world_elements() + "\"/>", 3);
      return indented(elements.empty() ? "<xs:choice minOccurs=\"0\">"
                                       : "<xs:choice minOccurs=\"0\" maxOccurs=\"unbounded\">",
                      2) +
             elements + any + indented("</xs:choice>", 2);
    }
    if (elements.empty()) {
      return "";
    }
    // In a group, or if some occur once and others often: any number in any order; otherwise each
    // once in any order, or a plain list.
    const bool once = spec.group && !many;
    const std::string model = is_choice(spec) ? "choice" : many ? "sequence" : "all";
    const bool needed = spec.nested || (spec.children.size() == 1 && spec.children[0].at_least > 0);
    const std::string occurs = model != "choice" ? ""
                               : needed          ? " maxOccurs=\"unbounded\""
                               : once            ? " minOccurs=\"0\""
                                                 : " minOccurs=\"0\" maxOccurs=\"unbounded\"";
    return indented("<xs:" + model + occurs + ">", 2) + elements +
           indented("</xs:" + model + ">", 2);
  }

  std::string child_element(const world::ElementSpec& parent, const world::ElementSpec& child) {
    std::string occurs;
    if (!is_choice(parent)) {
      occurs = " minOccurs=\"" + std::to_string(child.at_least) + "\"";
      occurs += child.at_most > 1 ? " maxOccurs=\"unbounded\"" : "";
    }
    // What is scattered gets its ids from its layout.
    const std::string where = (child.make ? "" : parent.name + ".") + child.name;
    return element(child.name, child.make ? type_of(child) : replacement_type(child), child.meaning,
                   unique(child) + (child.name == "robot" ? robot_constraints(where) : ""), 3,
                   occurs);
  }

  // Refers to a group of all elements of worlds that may replace another.
  std::string world_elements() {
    const std::string group = "world_elements";
    if (!types_.contains(group)) {
      types_[group] = "";
      const std::string own = std::exchange(own_, "");
      std::map<std::string, std::string> types;
      collect(world::vocabulary(), types);
      own_ = own;
      std::string elements;
      for (const auto& [name, type] : types) {
        elements += indented("<xs:element name=\"" + name + "\" type=\"" + type + "\"/>", 3);
      }
      types_[group] = indented("<xs:group name=\"" + group + "\">", 1) +
                      indented("<xs:choice>", 2) + elements + indented("</xs:choice>", 2) +
                      indented("</xs:group>", 1);
      order_.push_back(group);
    }
    return group;
  }

  // The types of all elements below, by name; two of the same name become xs:anyType.
  void collect(const world::ElementSpec& spec, std::map<std::string, std::string>& types) {
    const auto add = [&](const std::string& name, const std::string& type) {
      std::string& known = types[name];
      known = known.empty() || known == type ? type : "xs:anyType";
    };
    for (const world::ElementSpec& child : spec.children) {
      if (!child.plugins) {
        add(child.name, replacement_type(child));
        collect(child, types);
        continue;
      }
      for (const Declaration* declaration : host_.all(*child.plugins)) {
        add(declaration->name, plugin_type(child, *declaration));
        for (const ElementDeclaration& element : declaration->elements) {
          add(element.name, plugin_name(*declaration) + "." + element.name + ".type");
        }
      }
    }
  }

  // An element that replaces another has its id unless it sets one.
  std::string replacement_type(const world::ElementSpec& spec) {
    const world::AttributeSpec* id = spec.attribute("id");
    if (!id || !id->required) {
      return type_of(spec);
    }
    std::vector<world::Field> fields(spec.attributes.begin(), spec.attributes.end());
    for (world::Field& field : fields) {
      field.required &= field.name != "id";
    }
    return define(
        spec.name + ".replacement", [&] { return content(spec); }, fields);
  }

  static std::string plugin_name(const Declaration& declaration) {
    return std::string(plugin::kind_name(declaration.kind)) + "." + declaration.name;
  }

  std::string plugin_elements(const world::ElementSpec& spec) {
    std::string elements;
    for (const Declaration* declaration : host_.all(*spec.plugins)) {
      elements +=
          element(declaration->name, plugin_type(spec, *declaration), declaration->description,
                  declaration->hold ? behavior_constraint(plugin_name(*declaration)) : "", 3);
    }
    return elements;
  }

  std::string plugin_type(const world::ElementSpec& spec, const Declaration& declaration) {
    std::vector<world::Field> fields(spec.attributes.begin(), spec.attributes.end());
    for (const ParameterDeclaration& parameter : declaration.parameters) {
      if (!spec.attribute(parameter.name)) {  // the reader refuses such a plugin
        fields.push_back(world::field_of(parameter));
        fields.back().required = false;  // a template may give it
      }
    }
    const std::string name = plugin_name(declaration);
    return define(
        name, [&] { return inside(name, declaration); }, fields);
  }

  // The content of a plugin's element: the elements that it declares, any number in any order, and,
  // if it holds behaviours, <behaviors> and <coordinator>, each once.
  std::string inside(const std::string& name, const Declaration& declaration) {
    const std::string declared = declared_elements(name, declaration.elements);
    if (!declaration.hold) {
      return declared.empty() ? "" : sequence(declared);
    }
    std::vector<std::string> groups;
    for (const world::ElementSpec& group : world::coordination_vocabulary().children) {
      groups.push_back(element(group.name, type_of(group), group.meaning, "", 3));
    }
    // Written so that the next element alone decides its place in the model.
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

  // Refers to a group of the elements that a plugin declares, and defines that.
  // `nested`: those of its own list that may stand in an element.
  std::string declared_elements(const std::string& name, const std::vector<ElementDeclaration>& all,
                                const std::string& nested = "") {
    if (all.empty() && nested.empty()) return "";
    std::string elements;
    for (const ElementDeclaration& declared : all) {
      std::vector<world::Field> fields;
      for (const ParameterDeclaration& parameter : declared.parameters) {
        fields.push_back(world::field_of(parameter));
      }
      const std::string own = name + "." + declared.name;
      const std::string type = define(
          own,
          [&] {
            const std::string siblings = declared.nests ? of_list(name, all, declared.list) : "";
            const std::string inner = declared_elements(own, declared.elements, siblings);
            return inner.empty() ? "" : sequence(inner);
          },
          fields);
      elements += element(declared.name, type, declared.meaning, "", 3);
    }
    elements += nested;
    const std::string group = name + ".elements";
    types_[group] = indented("<xs:group name=\"" + group + "\">", 1) + indented("<xs:choice>", 2) +
                    elements + indented("</xs:choice>", 2) + indented("</xs:group>", 1);
    order_.push_back(group);
    return indented("<xs:group ref=\"" + group + "\" minOccurs=\"0\" maxOccurs=\"unbounded\"/>", 3);
  }

  static std::string of_list(const std::string& name, const std::vector<ElementDeclaration>& all,
                             std::size_t list) {
    std::string elements;
    for (const ElementDeclaration& each : all) {
      if (each.list != list) continue;
      elements += element(each.name, name + "." + each.name + ".type", each.meaning, "", 3);
    }
    return elements;
  }

  const plugin::Host& host_;
  std::string own_;                           // prefix of the types' names in another vocabulary
  std::map<std::string, std::string> types_;  // types and groups, by name
  std::vector<std::string> order_;
};

}  // namespace

std::string world_schema(const plugin::Host& host) { return Schema(host).of_worlds(); }

std::string schema_of(const world::ElementSpec& root, const std::string& about,
                      const plugin::Host& host) {
  return Schema(host).of(root, about);
}

}  // namespace elsie::reference
