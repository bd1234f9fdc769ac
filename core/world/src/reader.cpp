#include "elsie/world/reader.h"

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <utility>

#include "elsie/api/component.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/plugin/parameters.h"
#include "elsie/world/vocabulary.h"

#include "checks.h"
#include "files.h"
#include "ids.h"
#include "markup.h"
#include "path.h"
#include "problems.h"
#include "reading.h"
#include "templates.h"
#include "values.h"

namespace elsie::world {

namespace {

constexpr PluginKind kKinds[] = {PluginKind::sensor, PluginKind::behavior, PluginKind::coordinator};

// <sensors>, <behaviors>, <coordinator>.
std::string group_of(PluginKind kind) {
  return kind == PluginKind::coordinator ? "coordinator"
                                         : std::string(plugin::kind_name(kind)) + "s";
}

std::string in_words(const Attribute& attribute, const Element& element) {
  return attribute.name + "=\"" + attribute.value + "\" of <" + element.name + ">";
}

// Walks the tree and the vocabulary side by side and fills the objects.
class Reader {
 public:
  Reader(const plugin::Host& host, const Files& files, bool check_plugins, Problems& problems)
      : host_(host), files_(files), check_plugins_(check_plugins), problems_(problems) {}

  Reading read(const Element& root) {
    read_object(vocabulary(), root, &reading_.world);
    return std::move(reading_);
  }

 private:
  // Returns whether the object is as its element says: whether its own attributes are without
  // mistakes, and those of the elements that describe the object further.
  bool read_object(const ElementSpec& spec, const Element& element, void* object) {
    refuse_text(element);
    bool sound = true;
    for (const Attribute& attribute : element.attributes) {
      sound &= read_attribute(spec, element, attribute, object);
    }
    sound &= has_required(spec, element);
    std::map<const ElementSpec*, std::size_t> count;
    for (const Element& child : element.children) {
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
    if (!sound && !spec.plugins) {
      reading_.unsound.emplace(element.where.file, element.where.line);
    }
    return sound;
  }

  // The one that is being read.
  void mark_robot_incomplete() {
    reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
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
                                                    : near_or_all("<" + child.name + ">", names,
                                                                  "it may hold")));
    }
    return spec;
  }

  bool has_required(const ElementSpec& spec, const Element& element) {
    bool complete = true;
    for (const AttributeSpec& attribute : spec.attributes) {
      if (attribute.required && !element.find(attribute.name)) {
        problems_.add(element.where, "<" + element.name + "> lacks the attribute '" +
                                         attribute.name + "'; expected " + expectation(attribute));
        complete = false;
      }
    }
    return complete;
  }

  bool read_attribute(const ElementSpec& spec, const Element& element, const Attribute& attribute,
                      void* object) {
    const AttributeSpec* known = spec.attribute(attribute.name);
    if (!known) {
      // Editors associate the schema through these.
      if (spec.name == "world" &&
          (attribute.name == "xmlns:xsi" || attribute.name == "xsi:noNamespaceSchemaLocation")) {
        return true;
      }
      std::vector<std::string> names;
      for (const AttributeSpec& each : spec.attributes) {
        names.push_back(each.name);
      }
      problems_.add(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name +
                                         "'" + near_or_all(attribute.name, names, "it may have"));
      return false;
    }
    const Parsed parsed = parse_value(*known, attribute.value);
    if (!parsed.value) {
      problems_.add(attribute.where, in_words(attribute, element) + ": " + parsed.problem);
      return false;
    }
    if (known->refers_to != Reference::none) {
      reading_.mentions.push_back(
          {known->refers_to, attribute.value, attribute.where, in_words(attribute, element)});
    }
    if (known->set) {
      known->set(object, *parsed.value);
    }
    return true;
  }

  bool read_use(const ElementSpec& spec, const Element& element, void* object) {
    PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
    use.plugin = element.name;
    use.id = element.value("id");
    const Declaration* declaration = host_.find(*spec.plugins, element.name);
    if (!declaration) {
      problems_.add(element.where, explain_missing(*spec.plugins, element.name));
      mark_robot_incomplete();
      return false;
    }
    refuse_text(element);
    bool sound = true;
    for (const Element& child : element.children) {
      problems_.add(child.where, "<" + element.name + "> may not hold <" + child.name +
                                     ">; the parameters of a plugin are attributes of its element");
      sound = false;
    }
    for (const ParameterDeclaration& parameter : declaration->parameters) {
      if (spec.attribute(parameter.name)) {
        problems_.add(element.where, "the plugin '" + element.name + "' declares a parameter '" +
                                         parameter.name + "', which is an attribute of every " +
                                         spec.name + "; rename the parameter in the plugin");
        sound = false;
      }
    }
    for (const Attribute& attribute : element.attributes) {
      sound &= spec.attribute(attribute.name)
                   ? read_attribute(spec, element, attribute, object)
                   : read_parameter(spec, *declaration, element, attribute, use);
    }
    for (const ParameterDeclaration& parameter : declaration->parameters) {
      if (parameter.type == ParameterType::file && !element.find(parameter.name)) {
        sound &= find_default(parameter, element, use);
      }
    }
    if (sound && check_plugins_) {
      sound = try_out(*spec.plugins, *declaration, element, use);
    }
    return sound;
  }

  std::string explain_missing(PluginKind kind, const std::string& name) const {
    for (const PluginKind other : kKinds) {
      if (other != kind && host_.find(other, name)) {
        return "'" + name + "' is a " + std::string(plugin::kind_name(other)) +
               "; it belongs in <" + group_of(other) + ">";
      }
    }
    return host_.explain_missing(kind, name);
  }

  bool read_parameter(const ElementSpec& spec, const Declaration& declaration,
                      const Element& element, const Attribute& attribute, PluginUse& use) {
    const auto parameter =
        std::find_if(declaration.parameters.begin(), declaration.parameters.end(),
                     [&](const ParameterDeclaration& p) { return p.name == attribute.name; });
    if (parameter == declaration.parameters.end()) {
      std::vector<std::string> names;
      for (const ParameterDeclaration& each : declaration.parameters) {
        names.push_back(each.name);
      }
      for (const AttributeSpec& each : spec.attributes) {
        names.push_back(each.name);
      }
      problems_.add(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name +
                                         "'" + near_or_all(attribute.name, names, "it may have"));
      return false;
    }
    Parsed parsed = parse_value(field_of(*parameter), attribute.value);
    if (!parsed.value) {
      problems_.add(attribute.where, in_words(attribute, element) + ": " + parsed.problem);
      return false;
    }
    if (parameter->type == ParameterType::file && !attribute.value.empty()) {
      const auto file = files_.find(attribute.value, attribute.where);
      if (!file) {
        problems_.add(attribute.where, in_words(attribute, element) +
                                           ": there is no such file; looked " +
                                           files_.places(attribute.where));
        return false;
      }
      std::string path = Files::absolute(*file);
      use.file_names[parameter->name] = {path, files_.name_for_world(*file, attribute.value)};
      parsed.value = std::move(path);
    }
    use.parameters[parameter->name] = std::move(*parsed.value);
    return true;
  }

  // A default file is looked for in the data directories.
  bool find_default(const ParameterDeclaration& parameter, const Element& element, PluginUse& use) {
    const std::string& name = std::get<std::string>(parameter.default_value);
    if (name.empty()) {
      return true;
    }
    if (const auto file = files_.find_data(name)) {
      const std::string path = Files::absolute(*file);
      use.parameters[parameter.name] = path;
      use.file_names[parameter.name] = {path, ""};
      return true;
    }
    problems_.add(element.where, "<" + element.name + "> takes '" + name + "' for its parameter '" +
                                     parameter.name + "', but there is no such file " +
                                     files_.data_places() + "; give the parameter another file");
    return false;
  }

  // Makes the plugin's object once, to hear what it says about its parameters.
  bool try_out(PluginKind kind, const Declaration& declaration, const Element& element,
               const PluginUse& use) {
    try {
      const auto object = host_.create<Component>(kind, declaration.name);
      plugin::apply_parameters(declaration, *object, use.parameters);
      return true;
    } catch (const std::exception& error) {
      problems_.add(element.where, error.what());
      return false;
    }
  }

  const plugin::Host& host_;
  const Files& files_;
  const bool check_plugins_;
  Problems& problems_;
  Reading reading_;
};

// A file in another format has another vocabulary: nothing else in it is looked at.
void check_root(const Element& root, Problems& problems) {
  const std::string right = "<world format=\"" + std::to_string(kFormat) + "\">";
  if (root.name == "robot_template") {
    problems.add(root.where, "this file is a template of a robot; expected " + right +
                                 ", in which a <robot template=\"...\"> may use the template");
  } else if (root.name != "world") {
    problems.add(root.where, "found <" + root.name + "> as the root element; expected " + right);
  } else if (const Attribute* format = root.find("format")) {
    if (format->value != std::to_string(kFormat)) {
      problems.add(format->where, "format=\"" + format->value +
                                      "\" of <world>: this program reads " + "format \"" +
                                      std::to_string(kFormat) + "\"");
    }
  } else {
    problems.add(root.where, "<world> lacks its format; expected " + right);
  }
  problems.raise(root.where.file);
}

// "red" and "blue" are there by themselves; the file may change their colours and add others.
void add_default_teams(std::vector<Team>& teams) {
  std::vector<Team> all{{"red", {0xd0, 0x30, 0x30}}, {"blue", {0x30, 0x60, 0xd0}}};
  for (Team& team : teams) {
    const auto known = std::find_if(all.begin(), all.end(),
                                    [&](const Team& other) { return other.id == team.id; });
    if (known == all.end()) {
      all.push_back(std::move(team));
    } else {
      *known = std::move(team);
    }
  }
  teams = std::move(all);
}

}  // namespace

World read_world(const std::string& file, const plugin::Host& host, const ReadOptions& options) {
  return parse_world(read_text(file), file, host, options);
}

World parse_world(std::string_view text, const std::string& file, const plugin::Host& host,
                  const ReadOptions& options) {
  Problems problems;
  const Files files(file, options.data_directories);
  Element root = parse_markup(text, file);
  check_root(root, problems);

  complete_world_ids(root);
  for (const bool before_templates : {true, false}) {
    if (!before_templates) {
      Templates(files, problems).merge_all(root);
    }
    for (const std::string& override : options.overrides) {
      if (concerns_templates(override) == before_templates) {
        apply_override(root, override, problems);
      }
    }
  }

  Reading reading = Reader(host, files, options.check_plugins, problems).read(root);
  World& world = reading.world;
  world.file = file;
  add_default_teams(world.teams);
  std::stable_partition(world.boxes.begin(), world.boxes.end(),
                        [](const Box& box) { return box.kind != BoxKind::resource; });
  check_world(reading, root, host, problems);
  problems.raise(file);
  return std::move(world);
}

}  // namespace elsie::world
