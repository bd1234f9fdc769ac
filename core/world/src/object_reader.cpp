#include "elsie/world/object_reader.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "elsie/base/near_name.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/files.h"
#include "elsie/world/values.h"

#include "reading.h"
#include "refusals.h"

namespace elsie::world {

namespace {

using plugin::find_declared;

// Walks the tree and the vocabulary in parallel. What a plugin's element may hold is in the
// plugin's declaration.
class ObjectReader {
 public:
  ObjectReader(const plugin::Host* host, const Files* files, bool check_plugins, Reading& reading,
               Problems& problems)
      : host_(host),
        files_(files),
        check_plugins_(check_plugins),
        reading_(reading),
        problems_(problems) {}

  // Those that read something return whether the element had no mistakes.
  bool read_object(const ElementSpec& spec, const Element& element, void* object) {
    refuse_text(element);
    bool sound = read_attributes(element, &spec, object);
    return read_children(spec, element, object) && sound;
  }

 private:
  // What a plugin declares for an element, and where it goes; see PluginUse.
  struct Declared {
    const std::vector<ParameterDeclaration>& parameters;
    std::map<std::string, ParameterValue>& values;
    std::map<std::string, FileName>& file_names;
  };

  bool read_children(const ElementSpec& spec, const Element& element, void* object) {
    bool sound = true;
    std::map<const ElementSpec*, std::size_t> count;
    for (const Element& child : element.children) {
      if (spec.take && !spec.child(child.name)) {
        if (++count[nullptr] > 1) {
          problems_.add(child.where,
                        "<" + element.name + "> holds more than one element of a world");
          sound = false;
        } else {
          spec.take(object, markup_of(child));
        }
        continue;
      }
      const ElementSpec* child_spec = spec_of(spec, child);
      if (!child_spec) {
        sound = false;
        continue;
      }
      if (++count[child_spec] > child_spec->at_most) {
        problems_.add(child.where,
                      "<" + element.name + "> holds more than one " +
                          (child_spec->plugins ? child_spec->name : "<" + child_spec->name + ">"));
        continue;
      }
      const bool child_sound = read_child(*child_spec, child, object);
      sound &= child_sound || child_spec->group || spec.group;
    }
    for (const ElementSpec& child : spec.children) {
      if (child.at_least > count[&child]) {
        problems_.add(element.where, "<" + element.name + "> lacks a <" + child.name + ">");
        sound = false;
      }
    }
    return sound;
  }

  bool read_child(const ElementSpec& spec, const Element& element, void* parent) {
    void* object = spec.make(parent, element.where);
    if (element.incomplete) {
      mark_robot_incomplete();
    }
    const bool sound =
        spec.plugins ? read_use(spec, element, object) : read_object(spec, element, object);
    if (!sound) {
      reading_.flawed.push_back({&spec, element.where});
    }
    return sound;
  }

  void refuse_text(const Element& element) {
    if (!element.text.empty()) {
      const std::string line = element.text.substr(0, element.text.find_first_of("\r\n"));
      problems_.add({element.where.file, element.text_line},
                    "found the text '" + line + "' in <" + element.name +
                        ">; expected elements and comments only");
    }
  }

  // The description of a child, or null and a problem when there may be no such child.
  const ElementSpec* spec_of(const ElementSpec& parent, const Element& child) {
    if (!parent.children.empty() && parent.children.front().plugins) {
      return &parent.children.front();
    }
    const ElementSpec* spec = parent.child(child.name);
    if (!spec) {
      std::vector<std::string> names;
      for (const ElementSpec& known : parent.children) {
        names.push_back("<" + known.name + ">");
      }
      problems_.add(child.where, "<" + parent.name + "> may not hold <" + child.name + ">" +
                                     (names.empty() ? "; expected nothing in it"
                                                    : base::near_or_all("<" + child.name + ">",
                                                                        names, "it may hold")));
    }
    return spec;
  }

  bool has_required(const Field& field, const Element& element) {
    if (!field.required || element.find(field.name)) {
      return true;
    }
    problems_.add(element.where, "<" + element.name + "> lacks the attribute '" + field.name +
                                     "'; expected " + expectation(field));
    return false;
  }

  // Either of what describes the element may be null.
  bool read_attributes(const Element& element, const ElementSpec* spec, void* object,
                       const Declared* declared = nullptr) {
    bool sound = true;
    for (const Attribute& attribute : element.attributes) {
      const AttributeSpec* known = spec ? spec->attribute(attribute.name) : nullptr;
      const ParameterDeclaration* parameter =
          declared ? find_declared(declared->parameters, attribute.name) : nullptr;
      // Editors associate the schema through these.
      const bool is_of_schema =
          spec && spec->root &&
          (attribute.name == "xmlns:xsi" || attribute.name == "xsi:noNamespaceSchemaLocation");
      if (known) {
        sound &= read_attribute(*known, element, attribute, object);
      } else if (parameter) {
        sound &= read_parameter(*parameter, element, attribute, *declared);
      } else if (!is_of_schema) {
        refuse_attribute(element, attribute, spec, declared);
        sound = false;
      }
    }
    if (spec) {
      for (const AttributeSpec& attribute : spec->attributes) {
        sound &= has_required(attribute, element);
      }
    }
    if (declared) {
      for (const ParameterDeclaration& parameter : declared->parameters) {
        sound &= has_required(field_of(parameter), element);
        sound &= has_default(parameter, element, *declared);
      }
    }
    return sound;
  }

  void refuse_attribute(const Element& element, const Attribute& attribute, const ElementSpec* spec,
                        const Declared* declared) {
    std::vector<std::string> names;
    if (declared) {
      for (const ParameterDeclaration& parameter : declared->parameters) {
        names.push_back(parameter.name);
      }
    }
    if (spec) {
      for (const AttributeSpec& known : spec->attributes) {
        names.push_back(known.name);
      }
    }
    problems_.add(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name +
                                       "'" +
                                       base::near_or_all(attribute.name, names, "it may have"));
  }

  // None, and a problem, if the text is no such value.
  std::optional<ParameterValue> value_of(const Field& field, const Element& element,
                                         const Attribute& attribute) {
    Parsed parsed = parse_value(field, attribute.value);
    if (!parsed.value) {
      refuse_value(element, attribute, parsed.problem);
    }
    return std::move(parsed.value);
  }

  void refuse_value(const Element& element, const Attribute& attribute,
                    const std::string& problem) {
    problems_.add(attribute.where, in_words(attribute, element) + ": " + problem);
  }

  bool read_attribute(const AttributeSpec& known, const Element& element,
                      const Attribute& attribute, void* object) {
    const auto value = value_of(known, element, attribute);
    if (!value) {
      return false;
    }
    if (known.refers_to != Reference::none) {
      reading_.mentions.push_back(
          {known.refers_to, attribute.value, attribute.where, in_words(attribute, element)});
    }
    if (known.set) {
      known.set(object, *value);
    }
    return true;
  }

  // The robot that is being read.
  void mark_robot_incomplete() {
    reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
  }

  bool read_use(const ElementSpec& spec, const Element& element, void* object) {
    if (!host_) {
      throw std::logic_error("this vocabulary has plugins (" + spec.name + "), its reader none");
    }
    PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
    use.plugin = element.name;
    use.id = element.value("id");
    const Declaration* declaration = host_->find(*spec.plugins, element.name);
    if (!declaration) {
      problems_.add(element.where, explain_missing(*host_, *spec.plugins, element.name));
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
    const Declared declared{declaration->parameters, use.parameters, use.file_names};
    sound &= read_attributes(element, &spec, object, &declared);
    sound &= read_inside(spec, *declaration, element, object);
    if (sound && check_plugins_) {
      sound = try_out(*declaration, element, use);
    }
    return sound;
  }

  // Reads the elements in a plugin's element. Mistakes in what a behaviour holds do not count as
  // its.
  bool read_inside(const ElementSpec& spec, const Declaration& declaration, const Element& element,
                   void* object) {
    PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
    Coordination* inside = declaration.hold ? &spec.make_inside(object) : nullptr;
    bool sound = true;
    std::set<std::string> held;
    for (const Element& child : element.children) {
      const ElementSpec* group = inside ? coordination_vocabulary().child(child.name) : nullptr;
      if (const ElementDeclaration* declared = find_declared(declaration.elements, child.name)) {
        ElementUse& nested = use.elements.emplace_back();
        sound &= read_element(*declared, child, nested);
      } else if (!group) {
        problems_.add(child.where, "<" + element.name + "> may not hold <" + child.name + ">" +
                                       explain_child(*host_, declaration, child));
        sound = false;
      } else if (!held.insert(child.name).second) {
        problems_.add(child.where,
                      "<" + element.name + "> holds more than one <" + child.name + ">");
      } else {
        read_child(*group, child, inside);
      }
    }
    return sound;
  }

  bool read_element(const ElementDeclaration& declared, const Element& element, ElementUse& use) {
    use.element = element.name;
    use.location = element.where;
    refuse_text(element);
    bool sound = true;
    for (const Element& child : element.children) {
      problems_.add(child.where, "<" + element.name + "> may not hold <" + child.name + ">; " +
                                     (find_declared(declared.parameters, child.name)
                                          ? "its parameters are attributes"
                                          : "expected nothing in it"));
      sound = false;
    }
    const Declared content{declared.parameters, use.parameters, use.file_names};
    return read_attributes(element, nullptr, nullptr, &content) && sound;
  }

  bool read_parameter(const ParameterDeclaration& parameter, const Element& element,
                      const Attribute& attribute, const Declared& declared) {
    auto value = value_of(field_of(parameter), element, attribute);
    if (!value) {
      return false;
    }
    if (parameter.type != ParameterType::file ||
        (attribute.value.empty() && !parameter.facts.required)) {
      declared.values[parameter.name] = std::move(*value);
      return true;
    }
    if (attribute.value.empty()) {
      refuse_value(element, attribute, "expected the path of a file");
      return false;
    }
    const auto file = files_->find(attribute.value, attribute.where);
    if (!file) {
      refuse_value(element, attribute,
                   files_->why_not(attribute.where, attribute.name, attribute.value));
      return false;
    }
    set_file(parameter, *file, files_->name_for_world(*file, attribute.value), declared);
    return true;
  }

  static void set_file(const ParameterDeclaration& parameter, const std::string& file,
                       const std::string& name, const Declared& declared) {
    const std::string path = Files::absolute(file);
    declared.file_names[parameter.name] = {path, name};
    declared.values[parameter.name] = path;
  }

  // A default file must exist where no other is given; it is looked for in the data directories.
  bool has_default(const ParameterDeclaration& parameter, const Element& element,
                   const Declared& declared) {
    if (parameter.type != ParameterType::file || parameter.facts.required ||
        element.find(parameter.name)) {
      return true;
    }
    const std::string& name = std::get<std::string>(parameter.default_value);
    if (name.empty()) {
      return true;
    }
    if (const auto file = files_->find_data(name)) {
      set_file(parameter, *file, "", declared);
      return true;
    }
    problems_.add(element.where, "<" + element.name + "> takes '" + name + "' for its parameter '" +
                                     parameter.name + "', but there is no such file " +
                                     files_->data_places() + "; give the parameter another file");
    return false;
  }

  // Makes the plugin's object once, so that it checks its parameters.
  bool try_out(const Declaration& declaration, const Element& element, const PluginUse& use) {
    plugin::Call call({.plugin = use.plugin.c_str(),
                       .id = use.id.c_str(),
                       .file = element.where.file.c_str(),
                       .line = element.where.line,
                       .doing = "while it was given its parameters"});
    try {
      const auto object = host_->create<Component>(declaration.kind, declaration.name);
      plugin::hold_nothing(declaration, *object);
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

  const plugin::Host* host_;  // null: the vocabulary has no plugins
  const Files* files_;
  const bool check_plugins_;
  Reading& reading_;
  Problems& problems_;
};

}  // namespace

std::vector<Flawed> read_object(const ElementSpec& spec, const Element& root, void* object,
                                Problems& problems) {
  Reading reading;
  if (!ObjectReader(nullptr, nullptr, false, reading, problems).read_object(spec, root, object)) {
    reading.flawed.push_back({&spec, root.where});
  }
  return std::move(reading.flawed);
}

Reading read_tree(const Element& root, const plugin::Host& host, const Files& files,
                  bool check_plugins, Problems& problems) {
  Reading reading;
  ObjectReader(&host, &files, check_plugins, reading, problems)
      .read_object(vocabulary(), root, &reading.world);
  return reading;
}

void check_root(const Element& root, const std::string& name, int format,
                const std::map<std::string, std::string>& hints, Problems& problems) {
  const std::string number = std::to_string(format);
  const std::string right = "<" + name + " format=\"" + number + "\">";
  if (root.name != name) {
    const auto hint = hints.find(root.name);
    problems.add(root.where, hint != hints.end() ? hint->second
                                                 : "found <" + root.name +
                                                       "> as the root element; expected " + right);
  } else if (const Attribute* found = root.find("format")) {
    if (found->value != number) {
      problems.add(found->where, "format=\"" + found->value + "\" of <" + name +
                                     ">: this program reads format \"" + number + "\"");
    }
  } else {
    problems.add(root.where, "<" + name + "> lacks its format; expected " + right);
  }
  problems.raise<WorldError>(root.where.file);
}

}  // namespace elsie::world
