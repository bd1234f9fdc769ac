#include "tree_reader.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <set>
#include <utility>

#include "elsie/api/behavior.h"
#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/values.h"

namespace elsie::world {

namespace {

// <sensors>, <behaviors>, <coordinator>, <measures>.
std::string group_of(PluginKind kind) {
  return kind == PluginKind::coordinator ? "coordinator"
                                         : std::string(plugin::kind_name(kind)) + "s";
}

template <class Declared>
const Declared* find(const std::vector<Declared>& list, const std::string& name) {
  const auto found = std::find_if(list.begin(), list.end(),
                                  [&](const Declared& declared) { return declared.name == name; });
  return found == list.end() ? nullptr : &*found;
}

template <class Declared>
void append_names(const std::vector<Declared>& list, std::vector<std::string>& names) {
  for (const Declared& declared : list) {
    names.push_back(declared.name);
  }
}

constexpr const char* kAttributesOfItsElement =
    "; the parameters of a plugin are attributes of its element";

// Held by a behaviour that is only tried out.
class NothingInside final : public elsie::Coordination {
 public:
  Response respond(const Perception&) override { return {}; }
  void rate(std::span<const MotorCommand>, std::span<double> desirability) override {
    std::fill(desirability.begin(), desirability.end(), 0.0);
  }
  CommandSets command_sets() override { return {}; }
};

}  // namespace

Reading TreeReader::read(const Element& root) {
  read_object(vocabulary(), root, &reading_.world);
  return std::move(reading_);
}

void TreeReader::begin(const Element& element) {
  if (element.incomplete) {
    mark_robot_incomplete();
  }
}

void TreeReader::end(const ElementSpec& spec, const Element& element, bool sound) {
  if (!sound && !spec.plugins) {
    reading_.unsound.emplace(element.where.file, element.where.line);
  }
}

void TreeReader::mention(const AttributeSpec& field, const Attribute& attribute,
                         const Element& element) {
  reading_.mentions.push_back(
      {field.refers_to, attribute.value, attribute.where, in_words(attribute, element)});
}

// The robot that is being read.
void TreeReader::mark_robot_incomplete() {
  reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
}

bool TreeReader::read_use(const ElementSpec& spec, const Element& element, void* object) {
  PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
  use.plugin = element.name;
  use.id = element.value("id");
  const Declaration* declaration = host_.find(*spec.plugins, element.name);
  if (!declaration) {
    problems_.add(element.where, explain_missing(*spec.plugins, element.name));
    if (*spec.plugins != PluginKind::measure) {
      mark_robot_incomplete();
    }
    return false;
  }
  refuse_text(element);
  bool sound = true;
  for (const ParameterDeclaration& parameter : declaration->parameters) {
    if (spec.attribute(parameter.name)) {
      problems_.add(element.where, "the plugin '" + element.name + "' declares a parameter '" +
                                       parameter.name + "', which is an attribute of every " +
                                       spec.name + "; rename the parameter in the plugin");
      sound = false;
    }
  }
  const Values values{use.parameters, use.file_names};
  for (const Attribute& attribute : element.attributes) {
    const ParameterDeclaration* parameter = find(declaration->parameters, attribute.name);
    if (spec.attribute(attribute.name)) {
      sound &= read_attribute(spec, element, attribute, object);
    } else if (parameter) {
      sound &= read_parameter(*parameter, element, attribute, values);
    } else {
      std::vector<std::string> names;
      append_names(declaration->parameters, names);
      append_names(spec.attributes, names);
      refuse_attribute(element, attribute, names);
      sound = false;
    }
  }
  sound &= complete(declaration->parameters, element, values);
  sound &= read_inside(spec, *declaration, element, object);
  if (sound && check_plugins_) {
    sound = try_out(*declaration, element, use);
  }
  return sound;
}

// Reads the elements in a plugin's element. Mistakes in what a behaviour holds do not count as its.
bool TreeReader::read_inside(const ElementSpec& spec, const Declaration& declaration,
                             const Element& element, void* object) {
  PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
  Coordination* inside = declaration.hold ? &spec.make_inside(object) : nullptr;
  bool sound = true;
  std::set<std::string> held;
  for (const Element& child : element.children) {
    const ElementSpec* group = inside ? coordination_vocabulary().child(child.name) : nullptr;
    if (const ElementDeclaration* declared = find(declaration.elements, child.name)) {
      ElementUse& nested = use.elements.emplace_back();
      sound &= read_element(*declared, child, nested);
    } else if (!group) {
      problems_.add(child.where, "<" + element.name + "> may not hold <" + child.name + ">" +
                                     explain_child(declaration, child));
      sound = false;
    } else if (!held.insert(child.name).second) {
      problems_.add(child.where, "<" + element.name + "> holds more than one <" + child.name + ">");
    } else {
      read_child(*group, child, inside);
    }
  }
  return sound;
}

bool TreeReader::read_element(const ElementDeclaration& declared, const Element& element,
                              ElementUse& use) {
  use.element = element.name;
  use.location = element.where;
  refuse_text(element);
  bool sound = true;
  for (const Element& child : element.children) {
    problems_.add(child.where,
                  "<" + element.name + "> may not hold <" + child.name + ">; " +
                      (find(declared.parameters, child.name) ? "its parameters are attributes"
                                                             : "expected nothing in it"));
    sound = false;
  }
  const Values values{use.parameters, use.file_names};
  for (const Attribute& attribute : element.attributes) {
    if (const ParameterDeclaration* parameter = find(declared.parameters, attribute.name)) {
      sound &= read_parameter(*parameter, element, attribute, values);
    } else {
      std::vector<std::string> names;
      append_names(declared.parameters, names);
      refuse_attribute(element, attribute, names);
      sound = false;
    }
  }
  return complete(declared.parameters, element, values) && sound;
}

bool TreeReader::read_parameter(const ParameterDeclaration& parameter, const Element& element,
                                const Attribute& attribute, Values values) {
  Parsed parsed = parse_value(field_of(parameter), attribute.value);
  if (!parsed.value) {
    problems_.add(attribute.where, in_words(attribute, element) + ": " + parsed.problem);
    return false;
  }
  if (parameter.type == ParameterType::file &&
      (!attribute.value.empty() || parameter.facts.required)) {
    return read_file(parameter, element, attribute, values);
  }
  values.parameters[parameter.name] = std::move(*parsed.value);
  return true;
}

bool TreeReader::read_file(const ParameterDeclaration& parameter, const Element& element,
                           const Attribute& attribute, Values values) {
  if (attribute.value.empty()) {
    problems_.add(attribute.where, in_words(attribute, element) + ": expected the path of a file");
    return false;
  }
  const auto file = files_.find(attribute.value, attribute.where);
  if (!file) {
    problems_.add(attribute.where,
                  in_words(attribute, element) + ": " +
                      files_.why_not(attribute.where, attribute.name, attribute.value));
    return false;
  }
  const std::string path = Files::absolute(*file);
  values.file_names[parameter.name] = {path, files_.name_for_world(*file, attribute.value)};
  values.parameters[parameter.name] = path;
  return true;
}

// Checks the parameters without an attribute: they must not be required, and default files must
// exist.
bool TreeReader::complete(const std::vector<ParameterDeclaration>& parameters,
                          const Element& element, Values values) {
  std::vector<Field> fields;
  bool complete = true;
  for (const ParameterDeclaration& parameter : parameters) {
    fields.push_back(field_of(parameter));
    if (parameter.type == ParameterType::file && !parameter.facts.required &&
        !element.find(parameter.name)) {
      complete &= find_default(parameter, element, values);
    }
  }
  return has_required(fields, element) && complete;
}

// A default file is looked for in the data directories.
bool TreeReader::find_default(const ParameterDeclaration& parameter, const Element& element,
                              Values values) {
  const std::string& name = std::get<std::string>(parameter.default_value);
  if (name.empty()) {
    return true;
  }
  if (const auto file = files_.find_data(name)) {
    const std::string path = Files::absolute(*file);
    values.parameters[parameter.name] = path;
    values.file_names[parameter.name] = {path, ""};
    return true;
  }
  problems_.add(element.where, "<" + element.name + "> takes '" + name + "' for its parameter '" +
                                   parameter.name + "', but there is no such file " +
                                   files_.data_places() + "; give the parameter another file");
  return false;
}

// Makes the plugin's object once, so that it checks its parameters.
bool TreeReader::try_out(const Declaration& declaration, const Element& element,
                         const PluginUse& use) {
  NothingInside nothing;  // outlives the object that may point to it
  plugin::Call call({.plugin = use.plugin.c_str(),
                     .id = use.id.c_str(),
                     .file = element.where.file.c_str(),
                     .line = element.where.line,
                     .doing = "while it was given its parameters"});
  try {
    const auto object = host_.create<Component>(declaration.kind, declaration.name);
    if (declaration.hold) {
      declaration.hold(*object, nothing);
    }
    plugin::apply_parameters(declaration, *object, use.parameters,
                             {use.elements.begin(), use.elements.end()});
    if (const char* const changed = call.restore_arithmetic()) {
      problems_.add(element.where,
                    "plugin '" + use.plugin + "': it changed " + changed +
                        " for the whole program while it was given its parameters",
                    true);
      return false;
    }
    return true;
  } catch (const plugin::CreateError& error) {
    problems_.add(element.where, error.what(), true);
  } catch (const std::exception& error) {
    problems_.add(element.where, error.what());
  }
  return false;
}

std::string TreeReader::explain_missing(PluginKind kind, const std::string& name) const {
  for (const PluginKind other : plugin::kPluginKinds) {
    if (other != kind && host_.find(other, name)) {
      return "'" + name + "' is a " + std::string(plugin::kind_name(other)) + "; it belongs in <" +
             group_of(other) + ">";
    }
  }
  return host_.explain_missing(kind, name);
}

// The plugins that declare an element of this name.
std::vector<std::string> TreeReader::holders_of(const std::string& element) const {
  std::vector<std::string> holders;
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* plugin : host_.all(kind)) {
      if (find(plugin->elements, element)) {
        holders.push_back("<" + plugin->name + ">");
      }
    }
  }
  return holders;
}

// Why an element may not stand in a plugin's.
std::string TreeReader::explain_child(const Declaration& declaration, const Element& child) const {
  if (find(declaration.parameters, child.name)) {
    return kAttributesOfItsElement;
  }
  const ElementSpec& coordination = coordination_vocabulary();
  if (!declaration.hold && coordination.child(child.name)) {
    std::vector<std::string> holders;
    for (const Declaration* other : host_.all(PluginKind::behavior)) {
      if (other->hold) {
        holders.push_back("<" + other->name + ">");
      }
    }
    return holders.empty() ? "; no plugin that was found holds behaviours"
                           : "; plugins that hold behaviours: " + base::listed(holders);
  }
  std::vector<std::string> names;
  for (const ElementDeclaration& element : declaration.elements) {
    names.push_back("<" + element.name + ">");
  }
  if (declaration.hold) {
    for (const PluginKind kind : plugin::kPluginKinds) {
      if (host_.find(kind, child.name)) {
        return "; a " + std::string(plugin::kind_name(kind)) + " belongs in " +
               (kind == PluginKind::sensor    ? "the robot's"
                : kind == PluginKind::measure ? "the world's"
                                              : "its") +
               " <" + group_of(kind) + ">";
      }
    }
    for (const ElementSpec& group : coordination.children) {
      names.push_back("<" + group.name + ">");
    }
  }
  const std::vector<std::string> others = holders_of(child.name);
  return !others.empty() ? "; it belongs in " + base::listed(others)
         : names.empty() ? kAttributesOfItsElement
                         : base::near_or_all("<" + child.name + ">", names, "it may hold");
}

}  // namespace elsie::world
