#include "tree_reader.h"

#include <cstddef>
#include <utility>

#include "values.h"

namespace elsie::world {

Reading TreeReader::read(const Element& root) {
  read_object(vocabulary(), root, &reading_.world);
  return std::move(reading_);
}

bool TreeReader::read_object(const ElementSpec& spec, const Element& element, void* object) {
  refuse_text(element);
  bool sound = true;
  for (const Attribute& attribute : element.attributes) {
    sound &= read_attribute(spec, element, attribute, object);
  }
  sound &= has_required({spec.attributes.begin(), spec.attributes.end()}, element);
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

bool TreeReader::read_child(const ElementSpec& spec, const Element& element, void* parent) {
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
void TreeReader::mark_robot_incomplete() {
  reading_.incomplete_robots.insert(reading_.world.robots.size() - 1);
}

void TreeReader::refuse_text(const Element& element) {
  if (!element.text.empty()) {
    const std::string line = element.text.substr(0, element.text.find_first_of("\r\n"));
    problems_.add({element.where.file, element.text_line},
                  "found the text '" + line + "' in <" + element.name +
                      ">; expected elements and comments only");
  }
}

// The description of a child, or null and a problem when there may be no such child.
const ElementSpec* TreeReader::spec_of(const ElementSpec& parent, const Element& child) {
  if (!parent.children.empty() && parent.children.front().plugins) {
    return &parent.children.front();
  }
  const ElementSpec* spec = parent.child(child.name);
  if (!spec) {
    std::vector<std::string> names;
    for (const ElementSpec& known : parent.children) {
      names.push_back("<" + known.name + ">");
    }
    problems_.add(child.where,
                  "<" + parent.name + "> may not hold <" + child.name + ">" +
                      (names.empty() ? "; expected nothing in it"
                                     : near_or_all("<" + child.name + ">", names, "it may hold")));
  }
  return spec;
}

bool TreeReader::has_required(const std::vector<Field>& fields, const Element& element) {
  bool complete = true;
  for (const Field& field : fields) {
    if (field.required && !element.find(field.name)) {
      problems_.add(element.where, "<" + element.name + "> lacks the attribute '" + field.name +
                                       "'; expected " + expectation(field));
      complete = false;
    }
  }
  return complete;
}

void TreeReader::refuse_attribute(const Element& element, const Attribute& attribute,
                                  const std::vector<std::string>& names) {
  problems_.add(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name +
                                     "'" + near_or_all(attribute.name, names, "it may have"));
}

bool TreeReader::read_attribute(const ElementSpec& spec, const Element& element,
                                const Attribute& attribute, void* object) {
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
    refuse_attribute(element, attribute, names);
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

}  // namespace elsie::world
