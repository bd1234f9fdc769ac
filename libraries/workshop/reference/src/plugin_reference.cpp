// A plugin's declaration as part of a page.
#include <algorithm>
#include <cmath>
#include <vector>

#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/reference/reference.h"
#include "elsie/world/escaped.h"
#include "elsie/world/values.h"
#include "elsie/world/vocabulary.h"

#include "reference_table.h"

namespace elsie::reference {

namespace {

std::string number(double value) { return world::format_value(ParameterValue(value)); }

std::string type_in_words(ParameterType type) {
  switch (type) {
    case ParameterType::real:
      return "number";
    case ParameterType::integer:
      return "whole number";
    case ParameterType::boolean:
      return "true or false";
    case ParameterType::text:
      return "text";
    case ParameterType::file:
      return "file";
    case ParameterType::reals:
      break;
  }
  return "numbers";
}

std::string choices_in_words(const std::vector<std::string>& choices) {
  std::string text;
  for (const std::string& choice : choices) {
    text += (text.empty() ? "`" : ", `") + choice + "`";
  }
  return text;
}

std::string range_in_words(const world::Field& field) {
  const ParameterFacts& facts = field.facts;
  if (!facts.choices.empty()) {
    return choices_in_words(facts.choices);
  }
  // A range that follows from the member's type is left out, except for the sign.
  const double min = field.lowest == 0.0 ? std::max(facts.min, 0.0) : facts.min;
  const bool open = std::isfinite(facts.above) && facts.above >= min;
  const bool low = open || std::isfinite(min), high = std::isfinite(facts.max);
  const std::string range = low && high && !open ? number(min) + " to " + number(facts.max)
                            : low && high
                                ? "above " + number(facts.above) + ", at most " + number(facts.max)
                            : open ? "above " + number(facts.above)
                            : low  ? "at least " + number(min)
                            : high ? "at most " + number(facts.max)
                                   : "";
  return field.type == ParameterType::reals && !range.empty() ? "each " + range : range;
}

std::string table_of(const std::vector<ParameterDeclaration>& parameters) {
  if (parameters.empty()) {
    return "";
  }
  std::string text =
      "\n| parameter | type | unit | default | range | meaning |\n|---|---|---|---|---|---|\n";
  for (const ParameterDeclaration& parameter : parameters) {
    const world::Field field = world::field_of(parameter);
    text += table_row({"`" + field.name + "`", type_in_words(field.type), field.facts.unit,
                       default_text(field), range_in_words(field),
                       field.facts.meaning +
                           (field.is_live() ? "" : "; an edit in a run creates the plugin again")});
  }
  return text;
}

std::string lists_of_elements(const std::string& holder,
                              const std::vector<ElementDeclaration>& all);

// The attributes that differ from the defaults.
std::string markup_of(const ElementValue& value, const plugin::DeclaredElement& declared,
                      const std::string& indent = "") {
  std::string text = indent + "<" + value.element;
  for (const ParameterDeclaration& parameter : declared.parameters()) {
    const auto given = value.parameters.find(parameter.name);
    if (given != value.parameters.end() &&
        (parameter.facts.required || given->second != parameter.default_value)) {
      text += " " + parameter.name + "=\"" +
              world::escaped_attribute(world::format_value(given->second)) + "\"";
    }
  }
  std::string inside;
  for (const ElementValue& inner : value.elements) {
    inside += markup_of(inner, *declared.inside(inner.element), indent + "  ") + "\n";
  }
  return text + (inside.empty() ? "/>" : ">\n" + inside + indent + "</" + value.element + ">");
}

// The elements of one list. `holder`: what may hold them.
std::string list_of_elements(const std::string& holder, const std::vector<ElementDeclaration>& all,
                             std::size_t list) {
  std::vector<const ElementDeclaration*> elements;
  for (const ElementDeclaration& element : all) {
    if (element.list == list && !element.is_of_kind) {
      elements.push_back(&element);
    }
  }
  if (elements.empty()) return "";
  const bool one = elements.size() == 1;
  std::string text = "\n" + holder + " may hold any number of " +
                     (one ? "" : "these elements, in an order that counts:\n");
  for (const ElementDeclaration* element : elements) {
    const std::string tag = "`<" + element->name + ">`";
    text +=
        (one ? "" : "\n") + tag + ": " + element->meaning + ".\n" + table_of(element->parameters);
    if (element->nests) {
      text +=
          "\n" + tag + " may hold " + (one ? "others" : "all of these") + ", too, to any depth.\n";
    }
    text += lists_of_elements(tag, element->elements);
  }
  return text;
}

std::string lists_of_elements(const std::string& holder,
                              const std::vector<ElementDeclaration>& all) {
  std::string text;
  const std::size_t lists = all.empty() ? 0 : all.back().list + 1;
  for (std::size_t list = 0; list < lists; ++list) text += list_of_elements(holder, all, list);
  return text;
}

// What a plugin has when a file gives no element of a list.
std::string default_list(const Declaration& declaration, std::size_t list) {
  std::vector<std::string> names;
  for (const ElementDeclaration& element : declaration.elements) {
    if (element.list == list) names.push_back(element.name);
  }
  const std::string none =
      names.size() == 1 ? "Without any `<" + names[0] + ">`" : "Without any of them";
  std::string defaults;
  const plugin::DeclaredElement own(declaration);
  for (const ElementValue& value : declaration.default_elements) {
    const auto declared = own.inside(value.element);
    if (declared->element()->list == list) defaults += markup_of(value, *declared) + "\n";
  }
  return defaults.empty() ? "" : "\n" + none + " it is as with\n\n```xml\n" + defaults + "```\n";
}

// ": `ranges` (m, an array), `hit`"
std::string fields_of(const ReadingDeclaration& reading) {
  std::string text;
  for (const FieldDeclaration& field : reading.fields) {
    const std::string words = field.in_words();
    const std::size_t end = words.find(' ');
    text += (text.empty() ? ": `" : ", `") + words.substr(0, end) + "`" +
            (end == std::string::npos ? "" : words.substr(end));
  }
  return text;
}

}  // namespace

std::string plugin_declaration(const Declaration& declaration) {
  const std::string kind(plugin::kind_name(declaration.kind));
  std::string text = declaration.description + ".\n\nA" +
                     plugin::kind_with_article(declaration.kind).substr(1) + ", version " +
                     declaration.version + ".\n" + table_of(declaration.parameters);
  const std::size_t lists = declaration.elements.empty() ? 0 : declaration.elements.back().list + 1;
  for (std::size_t list = 0; list < lists; ++list) {
    text += list_of_elements("It", declaration.elements, list) + default_list(declaration, list);
  }
  if (declaration.hold) {
    text +=
        "\nIt holds other behaviours: `<behaviors>` and `<coordinator>` stand in its element as in "
        "a robot's.\n";
  }
  std::string of_kind;
  for (const ElementDeclaration& element : declaration.elements) {
    if (element.is_of_kind) of_kind += (of_kind.empty() ? "`<" : " and `<") + element.name + ">`";
  }
  if (!of_kind.empty()) {
    text +=
        "\nAs every " + kind + ", it may hold " + of_kind + ", which docs/worlds.md describes.\n";
  }
  for (const ReadingDeclaration& reading : declaration.needs) {
    text += "\nNeeds a sensor that makes readings of the kind `" + reading.kind + "`.\n";
  }
  for (const ReadingDeclaration& reading : declaration.produces) {
    text += "\nMakes readings of the kind `" + reading.kind + "`" + fields_of(reading) + ".\n";
  }
  for (const ReadingDeclaration& command : declaration.commands) {
    text += "\nGives commands of the kind `" + command.kind + "`.\n";
  }
  for (const ReadingDeclaration& command : declaration.takes) {
    text += "\nTakes commands of the kind `" + command.kind + "`" + fields_of(command) + ".\n";
  }
  for (const HeardDeclaration& message : declaration.hears) {
    text += "\nHears messages of the kind `" + message.kind + "`" + fields_of(message) + ".\n";
  }
  if (declaration.only_acts) text += "\nIt only acts: the coordinator does not see it.\n";
  if (!declaration.published.empty()) {
    text += "\nPublishes:\n\n| number | unit | meaning |\n|---|---|---|\n";
    for (const PublishedNumber& number : declaration.published) {
      text += table_row({"`" + number.name + "`", number.facts.unit, number.facts.meaning});
    }
  }
  for (const std::string& event : declaration.reacts_to) {
    text += "\nReacts to the event `" + event + "`.\n";
  }
  if (!declaration.events.empty()) {
    text += "\nEvents that it may raise:\n\n";
    for (const EventDeclaration& event : declaration.events) {
      text += "- `" + event.name + "`: " + event.meaning + "\n";
    }
  }
  return text;
}

}  // namespace elsie::reference
