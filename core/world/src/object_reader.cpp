#include "elsie/world/object_reader.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "elsie/base/near_name.h"
#include "elsie/base/thrown.h"
#include "elsie/plugin/call.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/files.h"
#include "elsie/world/values.h"
#include "elsie/world/world_tree.h"

#include "reading.h"
#include "refusals.h"

namespace elsie::world {
namespace {
using plugin::find_declared;

// Walks the tree and the vocabulary in parallel. The declaration of a plugin says what its element
// may hold.
class ObjectReader {
 public:
  ObjectReader(const plugin::Host* host, const Files* files, bool check_plugins, Reading& reading,
               Problems& problems)
      : host_(host),
        files_(files),
        check_plugins_(check_plugins),
        reading_(reading),
        problems_(problems) {}

  // Reads the root element of a file, or an inner element, without plugins. Of a tree that may be
  // changed, what has been read from lists is removed: its memory serves for the objects.
  template <class AnyElement>
  void read_object(const ElementSpec& spec, AnyElement& element, void* object) {
    refuse_text(element);
    read_attributes(element, &spec, object);
    read_children(spec, element, object);
  }

  // Notes which lists of a world are not taken over as a whole.
  void note_edited(const Element& world) {
    for (const auto& [list, kind] :
         {std::pair("teams", Reference::team), std::pair("robots", Reference::robot),
          std::pair("obstacles", Reference::obstacle),
          std::pair("resources", Reference::obstacle)}) {
      const Element* found = world.child(list);
      if (found && !found->unread) edited_.insert(kind);
    }
  }

  // Whether the element that is being read has no mistakes so far.
  bool sound() const { return sound_; }

 private:
  // The parameters that a plugin declares, and the maps for their values and names of files.
  struct Declared {
    const std::vector<ParameterDeclaration>& parameters;
    std::map<std::string, ParameterValue>& values;
    std::map<std::string, FileName>& file_names;
  };

  // Reports a mistake of the element that is being read.
  void refuse(const Location& where, std::string message, bool plugin_failed = false) {
    problems_.add(where, std::move(message), plugin_failed);
    sound_ = false;
  }
  void refuse_value(const Element& element, const Attribute& attribute,
                    const std::string& problem) {
    refuse(attribute.where, in_words(attribute, element) + ": " + problem);
  }

  // Reports text between the tags. The element's object stays valid.
  void refuse_text(const Element& element) {
    if (!element.text.empty()) {
      const std::string line = element.text.substr(0, element.text.find_first_of("\r\n"));
      problems_.add({element.where.file, element.text_line},
                    "found the text '" + line + "' in <" + element.name +
                        ">; expected elements and comments only");
    }
  }

  template <class AnyElement>
  void read_children(const ElementSpec& spec, AnyElement& element, void* object) {
    // A list of one kind; of several, nobody has counted each.
    if (spec.children.size() == 1 && spec.children.front().reserve) {
      spec.children.front().reserve(object, element.children.size());
    }
    std::map<const ElementSpec*, std::size_t> count;
    for (auto& child : element.children) {
      if (spec.take && !spec.child(child.name)) {
        if (++count[nullptr] > 1) {
          refuse(child.where, "<" + element.name + "> holds more than one element of a world");
        } else {
          spec.take(object, markup_of(child));
        }
      } else if (const ElementSpec* child_spec = spec_of(spec, child); !child_spec) {
        sound_ = false;
      } else if (++count[child_spec] > child_spec->at_most) {
        problems_.add(child.where,
                      "<" + element.name + "> holds more than one " +
                          (child_spec->plugins ? child_spec->name : "<" + child_spec->name + ">"));
      } else if (!take_over(*child_spec, child, object) &&
                 !read_child(*child_spec, child, object) && !child_spec->group && !spec.group) {
        sound_ = false;
      }
      if constexpr (!std::is_const_v<AnyElement>) {
        if (spec.group) child = Element();
      }
    }
    for (const ElementSpec& child : spec.children) {
      if (child.at_least > count[&child]) {
        refuse(element.where, "<" + element.name + "> lacks a <" + child.name + ">");
      }
    }
  }

  // Takes over what no edit leads to from a world in memory, which has been checked: a list of the
  // world, or a member of one. False: an edit leads to the element, so it must be read.
  bool take_over(const ElementSpec& spec, const Element& element, void* parent) {
    if (!element.unread) return false;
    const World& from = element.unread->world();
    if (!spec.group) {
      const DescribedObject& described = element.unread->meaning(element).described;
      spec.copy(parent, &from, described.order);
      note_mentions(spec, described.object);
      return true;
    }
    const ElementSpec& first = spec.children.front();
    if (first.share) first.share(parent, &from);
    if (first.share && !may_miss(first)) return true;
    for (const auto& [part, member] : spec.parts_of(&from)) {
      if (!first.share) member->copy(parent, &from, part.order);
      note_mentions(*member, part.object);
    }
    return true;
  }
  // Whether such an element may refer to something that an edit has removed.
  bool may_miss(const ElementSpec& spec) const {
    return std::any_of(
        spec.attributes.begin(), spec.attributes.end(),
        [&](const AttributeSpec& attribute) { return edited_.contains(attribute.refers_to); });
  }
  void note_mentions(const ElementSpec& spec, const void* object) {
    for (const AttributeSpec& attribute : spec.attributes) {
      if (!edited_.contains(attribute.refers_to)) continue;
      const std::string id = std::get<std::string>(*attribute.get(object));
      if (id.empty()) continue;
      reading_.mentions.push_back({attribute.refers_to, id, spec.location(object),
                                   attribute.name + "=\"" + id + "\" of <" + spec.name + ">"});
    }
    if (!spec.nested) return;
    for (const auto& [part, inner] : spec.parts_of(object)) note_mentions(*inner, part.object);
  }

  // Reads a child element; returns whether it has no mistakes.
  template <class AnyElement>
  bool read_child(const ElementSpec& spec, AnyElement& element, void* parent) {
    const bool parent_sound = std::exchange(sound_, true);
    void* object = spec.make(parent, element.where);
    if (spec.name == "robot") reading_.read_robots.push_back(reading_.world.robots.size() - 1);
    if (element.incomplete) mark_robot_incomplete();
    if (spec.plugins) {
      read_use(spec, element, object);
    } else {
      read_object(spec, element, object);
    }
    if (!sound_) {
      reading_.flawed.push_back({&spec, element.where});
    }
    return std::exchange(sound_, parent_sound);
  }

  // The description of a child; null, with a problem, if such a child is not allowed.
  const ElementSpec* spec_of(const ElementSpec& parent, const Element& child) {
    if (!parent.children.empty() && parent.children.front().plugins) {
      return &parent.children.front();
    }
    const ElementSpec* spec = parent.child(child.name);
    if (!spec) {
      const auto names = tags_of(parent.held());
      problems_.add(child.where, "<" + parent.name + "> may not hold <" + child.name + ">" +
                                     (names.empty() ? "; expected nothing in it"
                                                    : base::near_or_all("<" + child.name + ">",
                                                                        names, "it may hold")));
    }
    return spec;
  }

  // Reads the attributes of an element. `spec` or `declared` may be null.
  void read_attributes(const Element& element, const ElementSpec* spec, void* object,
                       const Declared* declared = nullptr) {
    for (const Attribute& attribute : element.attributes) {
      const AttributeSpec* known = spec ? spec->attribute(attribute.name) : nullptr;
      const ParameterDeclaration* parameter =
          declared ? find_declared(declared->parameters, attribute.name) : nullptr;
      // Editors find the schema through these attributes.
      const bool is_of_schema =
          spec && spec->root &&
          (attribute.name == "xmlns:xsi" || attribute.name == "xsi:noNamespaceSchemaLocation");
      if (known) {
        read_attribute(*known, element, attribute, object);
      } else if (parameter) {
        read_parameter(*parameter, element, attribute, *declared);
      } else if (!is_of_schema) {
        auto names = declared ? names_of(declared->parameters) : std::vector<std::string>();
        for (std::string& name : spec ? names_of(spec->attributes) : std::vector<std::string>()) {
          names.push_back(std::move(name));
        }
        refuse(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name + "'" +
                                    base::near_or_all(attribute.name, names, "it may have"));
      }
    }
    if (spec) {
      for (const AttributeSpec& attribute : spec->attributes) {
        require(attribute, element, attribute.refers_to);
      }
    }
    if (declared) {
      for (const ParameterDeclaration& parameter : declared->parameters) {
        if (parameter.facts.required) require(field_of(parameter), element);
        set_default(parameter, element, *declared);
      }
    }
  }

  void require(const Field& field, const Element& element, Reference of = Reference::none) {
    if (!field.required || element.find(field.name)) return;
    const std::string what = "<" + element.name + "> lacks the attribute '" + field.name + "'";
    of == Reference::none ? refuse(element.where, what + "; expected " + expectation(field))
                          : reading_.mentions.push_back({of, "", element.where, what});
  }

  void read_attribute(const AttributeSpec& known, const Element& element,
                      const Attribute& attribute, void* object) {
    const Parsed parsed = parse_value(known, attribute.value);
    if (!parsed.value) {
      refuse_value(element, attribute, "expected " + parsed.expected);
      return;
    }
    if (known.refers_to != Reference::none) {
      reading_.mentions.push_back(
          {known.refers_to, attribute.value, attribute.where, in_words(attribute, element)});
    }
    if (known.set) known.set(object, *parsed.value);
    // A new element of a running world has no meaning in its tree.
    if (known.name == "energy" && element.name == "robot" &&
        (!element.object || attribute.where.is_edit())) {
      reading_.charged_robots.insert(reading_.world.robots.size() - 1);
    }
  }

  // The robot that is being read.
  void mark_robot_incomplete() {
    reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
  }

  void read_use(const ElementSpec& spec, const Element& element, void* object) {
    if (!host_) {
      throw std::logic_error("this vocabulary has plugins (" + spec.name + "), its reader none");
    }
    PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
    use.plugin = element.name;
    use.id = element.value("id");
    const Declaration* declaration = host_->find(*spec.plugins, element.name);
    if (!declaration) {
      refuse(element.where, explain_missing(*host_, *spec.plugins, element.name));
      if (!plugin::is_of_world(*spec.plugins)) mark_robot_incomplete();
      return;
    }
    refuse_text(element);
    for (const ParameterDeclaration& parameter : declaration->parameters) {
      if (spec.attribute(parameter.name)) {
        refuse(element.where, "the plugin '" + element.name + "' declares a parameter '" +
                                  parameter.name + "', which is an attribute of every " +
                                  spec.name + "; rename the parameter in the plugin");
      }
    }
    const Declared declared{declaration->parameters, use.parameters, use.file_names};
    read_attributes(element, &spec, object, &declared);
    read_inside(spec, *declaration, element, object);
    if (sound_ && check_plugins_) try_out(*declaration, element, use);
  }

  // Reads the elements in a plugin's element. Mistakes in behaviours inside a behaviour do not
  // count as mistakes of the outer one.
  void read_inside(const ElementSpec& spec, const Declaration& declaration, const Element& element,
                   void* object) {
    PluginUse& use = const_cast<PluginUse&>(*spec.use(object));
    Coordination* inside = declaration.hold ? &spec.make_inside(object) : nullptr;
    std::set<std::string> held;
    for (const Element& child : element.children) {
      const ElementSpec* group = inside ? coordination_vocabulary().child(child.name) : nullptr;
      if (const auto declared = plugin::DeclaredElement(declaration).inside(child.name)) {
        read_element(*declared, child, use.elements.emplace_back());
      } else if (!group) {
        refuse(child.where, "<" + element.name + "> may not hold <" + child.name + ">" +
                                explain_child(*host_, declaration, child));
      } else if (!held.insert(child.name).second) {
        problems_.add(child.where,
                      "<" + element.name + "> holds more than one <" + child.name + ">");
      } else {
        read_child(*group, child, inside);
      }
    }
  }

  void read_element(const plugin::DeclaredElement& declared, const Element& element,
                    ElementUse& use) {
    use.element = element.name;
    use.location = element.where;
    refuse_text(element);
    for (const Element& child : element.children) {
      if (const auto inner = declared.inside(child.name)) {
        read_element(*inner, child, use.elements.emplace_back());
      } else {
        refuse(child.where, "<" + element.name + "> may not hold <" + child.name + ">" +
                                explain_inner(declared, child));
      }
    }
    const Declared content{declared.parameters(), use.parameters, use.file_names};
    read_attributes(element, nullptr, nullptr, &content);
  }

  void read_parameter(const ParameterDeclaration& parameter, const Element& element,
                      const Attribute& attribute, const Declared& declared) {
    Parsed parsed = plugin::parse_value(parameter, attribute.value);
    if (!parsed.value) {
      refuse_value(element, attribute, "expected " + parsed.expected);
    } else if (parameter.type != ParameterType::file ||
               (attribute.value.empty() && field_of(parameter).may_be_no_file())) {
      declared.values[parameter.name] = std::move(*parsed.value);
    } else if (const auto file = files_->find(attribute.value, attribute.where)) {
      set_file(parameter, *file, files_->name_for_world(*file, attribute.value), declared);
    } else {
      refuse_value(element, attribute,
                   files_->why_not(attribute.where, attribute.name, attribute.value));
    }
  }

  static void set_file(const ParameterDeclaration& parameter, const std::string& file,
                       const std::string& name, const Declared& declared) {
    const std::string path = Files::absolute(file);
    declared.file_names[parameter.name] = {path, name};
    declared.values[parameter.name] = path;
  }

  // Sets a default; a default file is searched in the data directories.
  void set_default(const ParameterDeclaration& parameter, const Element& element,
                   const Declared& declared) {
    if (parameter.type != ParameterType::file || parameter.facts.required ||
        element.find(parameter.name)) {
      return;
    }
    const std::string& name = std::get<std::string>(parameter.default_value);
    const auto file = name.empty() ? std::nullopt : files_->find_data(name);
    if (file) {
      set_file(parameter, *file, "", declared);
    } else if (!name.empty()) {
      refuse(element.where, "<" + element.name + "> takes '" + name + "' for its parameter '" +
                                parameter.name + "', but there is no such file " +
                                files_->data_places() + "; give the parameter another file");
    }
  }

  // Makes an object of the plugin once, so that it checks its parameters.
  void try_out(const Declaration& declaration, const Element& element, const PluginUse& use) {
    plugin::Call call({.plugin = &use.plugin,
                       .id = &use.id,
                       .file = element.where.file.text().c_str(),
                       .line = element.where.line,
                       .doing = "while it was given its parameters"});
    try {
      const auto object = host_->create<Component>(declaration.kind, declaration.name);
      plugin::hold_nothing(declaration, *object);
      plugin::apply_parameters(declaration, *object, use.parameters, values_of(use.elements));
      if (const char* const changed = call.restore_arithmetic()) {
        refuse(element.where,
               "plugin '" + use.plugin + "': it changed " + changed +
                   " for the whole program while it was given its parameters",
               true);
      }
    } catch (const plugin::CreateError& error) {
      refuse(element.where, error.what(), true);
    } catch (...) {
      refuse(element.where, base::what_was_thrown());
    }
  }

  const plugin::Host* host_;  // null: the vocabulary has no plugins
  const Files* files_;
  const bool check_plugins_;
  Reading& reading_;
  Problems& problems_;
  std::set<Reference> edited_;  // the lists that an edit leads into
  bool sound_ = true;           // whether the element that is being read has no mistakes so far
};
}  // namespace

std::vector<Flawed> read_object(const ElementSpec& spec, const Element& root, void* object,
                                Problems& problems) {
  Reading reading;
  ObjectReader reader(nullptr, nullptr, false, reading, problems);
  reader.read_object(spec, root, object);
  if (!reader.sound()) {
    reading.flawed.push_back({&spec, root.where});
  }
  return std::move(reading.flawed);
}

Reading read_tree(Element& root, const plugin::Host& host, const Files& files, bool check_plugins,
                  Problems& problems) {
  Reading reading;
  ObjectReader reader(&host, &files, check_plugins, reading, problems);
  reader.note_edited(root);
  reader.read_object(vocabulary(), root, &reading.world);
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
