#include "elsie/reference/reference.h"

#include <set>
#include <vector>

#include "elsie/world/values.h"
#include "elsie/world/vocabulary.h"

#include "reference_table.h"

namespace elsie::reference {

std::string cell(const std::string& text) {
  std::string escaped_text;
  bool is_code = false;     // between two `
  bool is_element = false;  // between < and >, which become code: readable in a terminal, too
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    is_code ^= c == '`';
    if (c == '<' && !is_code && text.find('>', i) != std::string::npos) {
      is_element = true;
      escaped_text += '`';
    }
    escaped_text += c == '|' ? "\\|" : std::string(1, c);
    if (c == '>' && is_element) {
      is_element = false;
      escaped_text += '`';
    }
  }
  return escaped_text;
}

std::string table_row(std::initializer_list<std::string> texts) {
  std::string row = "|";
  for (const std::string& text : texts) {
    row += " " + cell(text) + " |";
  }
  return row + "\n";
}

std::string default_text(const world::Field& field) {
  if (field.required) {
    return "required";
  }
  const std::string text = field.default_value ? world::format_value(*field.default_value) : "";
  return text.empty() ? "" : "`" + text + "`";
}

namespace {

std::string value_in_words(const world::Field& field) {
  switch (field.refers_to) {
    case world::Reference::team:
      return "the id of a team";
    case world::Reference::robot:
      return "the id of a robot";
    case world::Reference::obstacle:
      return "the id of a box";
    case world::Reference::none:
      break;
  }
  return field.form == world::TextForm::id ? "an id" : world::expectation(field);
}

const char* in_words(world::Cost cost) {
  switch (cost) {
    case world::Cost::nothing:
      return "an edit costs nothing";
    case world::Cost::value:
      return "may change while the world runs";
    case world::Cost::object:
      return "an edit creates the plugin's object again";
    case world::Cost::body:
      return "an edit creates the robot's body again";
    case world::Cost::engine:
      break;
  }
  return "an edit creates the physics engine again";
}

/// `cost`: the cost of attributes that do not specify one.
std::string table(const std::vector<world::Field>& fields, world::Cost cost) {
  if (fields.empty()) {
    return "";
  }
  std::string text = "\n| attribute | value | default | meaning |\n|---|---|---|---|\n";
  for (const world::Field& field : fields) {
    text += table_row({"`" + field.name + "`", value_in_words(field), default_text(field),
                       field.facts.meaning +
                           (field.cost == cost ? "" : std::string("; ") + in_words(field.cost))});
  }
  return text;
}

std::string list_of_children(const world::ElementSpec& spec) {
  std::string list;
  for (const world::ElementSpec& child : spec.held()) {
    list += (list.empty() ? "" : ", ");
    list += child.plugins ? "an element named after any " + child.name + " plugin"
                          : "`<" + child.name + ">`";
  }
  if (spec.take) {
    list += std::string(list.empty() ? "" : ", ") + "an element of a world";
  }
  return list;
}

void describe(const world::ElementSpec& spec, const std::string& path, std::string& text) {
  const bool is_use = spec.plugins.has_value();
  text += "\n## " + path + (is_use ? " / *any " + spec.name + " plugin*" : "") + "\n\n" +
          cell(spec.meaning) + ".\n";
  if (!spec.held().empty() || spec.take) {
    text += "\nHolds: " + list_of_children(spec) + ".\n";
  }
  if (is_use) {
    text +=
        "\nIts attributes are these and the plugin's parameters; its content is what the plugin "
        "declares.";
    text += spec.inside ? " A behaviour that holds others has " +
                              list_of_children(world::coordination_vocabulary()) +
                              " in it, as a robot has, to any depth.\n"
                        : "\n";
  }
  if (spec.cost != world::Cost::nothing) {
    text += "\nWhile the world runs, " + std::string(in_words(spec.cost)) + ".\n";
  }
  text += table({spec.attributes.begin(), spec.attributes.end()}, spec.cost);
  for (const world::ElementSpec& child : spec.children) {
    describe(child, child.plugins ? path : path + " / " + child.name, text);
  }
}

void describe_named(const world::ElementSpec& spec, const std::string& name,
                    const std::string& path, std::string& text) {
  for (const world::ElementSpec& child : spec.children) {
    const std::string below = child.plugins ? path : path + " / " + child.name;
    if (child.name == name && !child.plugins) {
      describe(child, below, text);
    } else {
      describe_named(child, name, below, text);
    }
  }
}

}  // namespace

std::string element_reference(const world::ElementSpec& root, const std::string& name) {
  std::string text;
  describe_named(root, name, root.name, text);
  return text;
}

void list_elements(const world::ElementSpec& root, std::set<std::string>& names) {
  for (const world::ElementSpec& child : root.children) {
    if (!child.plugins) {
      names.insert(child.name);
    }
    list_elements(child, names);
  }
}

std::string world_reference() {
  std::string text =
      "# World files: elements and attributes\n\nFormat " + std::to_string(world::kFormat) +
      ". Units are SI; angles are in degrees, as their names say. x points east, y north, z up; "
      "headings are counter-clockwise from east. Numbers are written with a point, and are "
      "finite.\n\nEach element states the cost of an edit in a running world, and so does each "
      "attribute with another cost. Objects that are created again take over the state of the "
      "objects "
      "that remain. Where nothing is stated, an edit has no cost.\n";
  describe(world::vocabulary(), "world", text);
  text += "\n## robot_template\n\n" + cell(world::template_vocabulary().meaning) +
          ". It has what a `<robot>` has, but no `id`, and a `format`; the robot that names it "
          "overrides what differs.\n";
  return text;
}

std::string vocabulary_reference(const world::ElementSpec& root) {
  std::string text;
  describe(root, root.name, text);
  return text;
}

std::string plugin_reference(const Declaration& declaration) {
  return "# " + declaration.name + "\n\n" + plugin_declaration(declaration);
}

}  // namespace elsie::reference
