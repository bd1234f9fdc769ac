#include "elsie/world/object_reader.h"

#include <cstddef>
#include <map>
#include <stdexcept>

#include "elsie/base/near_name.h"
#include "elsie/world/values.h"

namespace elsie::world {

bool ObjectReader::read_object(const ElementSpec& spec, const Element& element, void* object) {
  refuse_text(element);
  bool sound = true;
  for (const Attribute& attribute : element.attributes) {
    sound &= read_attribute(spec, element, attribute, object);
  }
  sound &= has_required({spec.attributes.begin(), spec.attributes.end()}, element);
  return read_children(spec, element, object) && sound;
}

bool ObjectReader::read_children(const ElementSpec& spec, const Element& element, void* object) {
  bool sound = true;
  std::map<const ElementSpec*, std::size_t> count;
  for (const Element& child : element.children) {
    if (spec.take && !spec.child(child.name)) {
      if (++count[nullptr] > 1) {
        problems_.add(child.where, "<" + element.name + "> holds more than one element of a world");
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

bool ObjectReader::read_child(const ElementSpec& spec, const Element& element, void* parent) {
  void* object = spec.make(parent, element.where);
  begin(element);
  const bool sound =
      spec.plugins ? read_use(spec, element, object) : read_object(spec, element, object);
  end(spec, element, sound);
  return sound;
}

bool ObjectReader::read_use(const ElementSpec& spec, const Element&, void*) {
  throw std::logic_error("this vocabulary has plugins (" + spec.name + "), and its reader has not");
}

void ObjectReader::refuse_text(const Element& element) {
  if (!element.text.empty()) {
    const std::string line = element.text.substr(0, element.text.find_first_of("\r\n"));
    problems_.add({element.where.file, element.text_line},
                  "found the text '" + line + "' in <" + element.name +
                      ">; expected elements and comments only");
  }
}

// The description of a child, or null and a problem when there may be no such child.
const ElementSpec* ObjectReader::spec_of(const ElementSpec& parent, const Element& child) {
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
                                                  : base::near_or_all("<" + child.name + ">", names,
                                                                      "it may hold")));
  }
  return spec;
}

bool ObjectReader::has_required(const std::vector<Field>& fields, const Element& element) {
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

void ObjectReader::refuse_attribute(const Element& element, const Attribute& attribute,
                                    const std::vector<std::string>& names) {
  problems_.add(attribute.where, "<" + element.name + "> has no attribute '" + attribute.name +
                                     "'" + base::near_or_all(attribute.name, names, "it may have"));
}

bool ObjectReader::read_attribute(const ElementSpec& spec, const Element& element,
                                  const Attribute& attribute, void* object) {
  const AttributeSpec* known = spec.attribute(attribute.name);
  if (!known) {
    // Editors associate the schema through these.
    if (spec.root &&
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
    mention(*known, attribute, element);
  }
  if (known->set) {
    known->set(object, *parsed.value);
  }
  return true;
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
