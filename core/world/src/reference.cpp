#include "elsie/world/reference.h"

#include <vector>

#include "elsie/plugin/kind_name.h"
#include "elsie/world/vocabulary.h"

#include "values.h"

namespace elsie::world {

namespace {

std::string value_in_words(const Field& field) {
  switch (field.refers_to) {
    case Reference::team:
      return "the id of a team";
    case Reference::robot:
      return "the id of a robot";
    case Reference::box:
      return "the id of a box";
    case Reference::none:
      break;
  }
  return field.form == TextForm::id ? "an id" : expectation(field);
}

std::string cell(const std::string& text) {
  std::string escaped_text;
  for (const char c : text) {
    escaped_text += c == '|' ? "\\|" : c == '<' ? "&lt;" : std::string(1, c);
  }
  return escaped_text;
}

std::string default_text(const Field& field) {
  if (field.required) {
    return "required";
  }
  const std::string text = field.default_value ? format_value(*field.default_value) : "";
  return text.empty() ? "" : "`" + text + "`";
}

std::string table(const std::vector<Field>& fields) {
  if (fields.empty()) {
    return "";
  }
  std::string text = "\n| attribute | value | default | meaning |\n|---|---|---|---|\n";
  for (const Field& field : fields) {
    text += "| `" + field.name + "` | " + cell(value_in_words(field)) + " | " +
            cell(default_text(field)) + " | " + cell(field.facts.meaning) + " |\n";
  }
  return text;
}

std::string list_of_children(const ElementSpec& spec) {
  std::string list;
  for (const ElementSpec& child : spec.children) {
    list += (list.empty() ? "" : ", ");
    list += child.plugins ? "an element named after any " + child.name + " plugin"
                          : "`<" + child.name + ">`";
  }
  return list;
}

void describe(const ElementSpec& spec, const std::string& path, std::string& text) {
  const bool is_use = spec.plugins.has_value();
  text += "\n## " + path + (is_use ? " / *any " + spec.name + " plugin*" : "") + "\n\n" +
          cell(spec.meaning) + ".\n";
  if (!spec.children.empty()) {
    text += "\nHolds: " + list_of_children(spec) + ".\n";
  }
  if (is_use) {
    text += "\nIts attributes are these and the plugin's parameters.\n";
  }
  text += table({spec.attributes.begin(), spec.attributes.end()});
  for (const ElementSpec& child : spec.children) {
    describe(child, child.plugins ? path : path + " / " + child.name, text);
  }
}

}  // namespace

std::string world_reference() {
  std::string text =
      "# World files: elements and attributes\n\nFormat " + std::to_string(kFormat) +
      ". SI units; angles in degrees, and their names say so. x points east, y north, z up; "
      "headings are counter-clockwise from east. Numbers are written with a point, and are "
      "finite.\n";
  describe(vocabulary(), "world", text);
  text += "\n## robot_template\n\n" + cell(template_vocabulary().meaning) +
          ". It has what a `<robot>` has, but no `id`, and a `format`; the robot that names it "
          "overrides what differs.\n";
  return text;
}

std::string plugin_reference(const Declaration& declaration) {
  const std::string kind(plugin::kind_name(declaration.kind));
  std::string text = "# " + declaration.name + "\n\n" + declaration.description + ".\n\nA " + kind +
                     ", version " + declaration.version + ".\n";
  std::vector<Field> fields;
  for (const ParameterDeclaration& parameter : declaration.parameters) {
    fields.push_back(field_of(parameter));
  }
  text += table(fields);
  for (const ReadingDeclaration& reading : declaration.needs) {
    text += "\nNeeds a sensor that makes readings of the kind `" + reading.kind + "`.\n";
  }
  for (const ReadingDeclaration& reading : declaration.produces) {
    text += "\nMakes readings of the kind `" + reading.kind + "`.\n";
  }
  if (!declaration.events.empty()) {
    text += "\nEvents that it may raise:\n\n";
    for (const EventDeclaration& event : declaration.events) {
      text += "- `" + event.name + "`: " + event.meaning + "\n";
    }
  }
  return text;
}

}  // namespace elsie::world
