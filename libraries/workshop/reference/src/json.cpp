#include "elsie/reference/json.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "elsie/api/simulator_events.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/vocabulary.h"

namespace elsie::reference {
namespace {

using plugin::kind_name;

Json to_json(const ParameterValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

const char* type_name(ParameterType type) {
  switch (type) {
    case ParameterType::real:
      return "number";
    case ParameterType::integer:
      return "integer";
    case ParameterType::boolean:
      return "boolean";
    case ParameterType::text:
      return "text";
    case ParameterType::file:
      return "file";
    case ParameterType::reals:
      break;
  }
  return "numbers";
}

Json to_json(const ParameterDeclaration& parameter) {
  Json json{{"name", parameter.name},
            {"type", type_name(parameter.type)},
            {"unit", parameter.facts.unit},
            {"default", to_json(parameter.default_value)},
            {"meaning", parameter.facts.meaning}};
  const auto bound = [&json](const char* name, double value) {
    if (std::isfinite(value)) {
      json[name] = value;
    }
  };
  bound("min", parameter.facts.min);
  bound("above", parameter.facts.above);
  bound("max", parameter.facts.max);
  if (!parameter.facts.choices.empty()) {
    json["choices"] = parameter.facts.choices;
  }
  if (parameter.facts.required) {
    json["required"] = true;
  }
  if (!parameter.facts.live) {
    json["live"] = false;
  }
  return json;
}

Json to_json(const std::vector<ParameterDeclaration>& parameters) {
  Json json = Json::array();
  for (const ParameterDeclaration& parameter : parameters) {
    json.push_back(to_json(parameter));
  }
  return json;
}

Json to_json(const ElementValue& value) {
  Json parameters = Json::object();
  for (const auto& [name, given] : value.parameters) {
    parameters[name] = to_json(given);
  }
  Json json{{"name", value.element}, {"parameters", parameters}};
  for (const ElementValue& inner : value.elements) json["elements"].push_back(to_json(inner));
  return json;
}

Json to_json(const std::vector<ElementDeclaration>& elements) {
  Json json = Json::array();
  for (const ElementDeclaration& element : elements) {
    json.push_back({{"name", element.name},
                    {"meaning", element.meaning},
                    {"list", element.list},
                    {"parameters", to_json(element.parameters)}});
    if (!element.elements.empty()) json.back()["elements"] = to_json(element.elements);
    if (element.nests) json.back()["nests"] = true;
  }
  return json;
}

const char* to_text(world::Cost cost) {
  switch (cost) {
    case world::Cost::nothing:
      return "nothing";
    case world::Cost::value:
      return "in place";
    case world::Cost::object:
      return "object";
    case world::Cost::body:
      return "body";
    case world::Cost::engine:
      break;
  }
  return "engine";
}

Json to_json(const world::Field& field) {
  ParameterDeclaration parameter;
  parameter.name = field.name;
  parameter.type = field.type;
  parameter.facts = field.facts;
  parameter.facts.required = field.required;
  Json json = to_json(parameter);
  json["default"] = field.default_value ? to_json(*field.default_value) : Json();
  if (!field.facts.choices.empty()) {
    json["type"] = "choice";
  }
  if (field.form != world::TextForm::any) {
    json["form"] = field.form == world::TextForm::id ? "id" : "colour";
  }
  if (field.refers_to != world::Reference::none) {
    json["refers_to"] = field.refers_to == world::Reference::team    ? "team"
                        : field.refers_to == world::Reference::robot ? "robot"
                                                                     : "box";
  }
  json["cost"] = to_text(field.cost);
  return json;
}

void add(Json& elements, const world::ElementSpec& spec) {
  Json& json = elements[spec.name];
  if (json.is_null()) {
    json = {{"meaning", spec.meaning},
            {"attributes", Json::array()},
            {"children", Json::array()},
            {"cost", to_text(spec.cost)}};
  }
  const bool is_new = json["attributes"].empty();
  for (const world::AttributeSpec& attribute : spec.attributes) {
    if (is_new) {
      json["attributes"].push_back(to_json(static_cast<const world::Field&>(attribute)));
    }
  }
  if (spec.group) {
    json["members"] = spec.members;
  }
  const std::string name = spec.name;
  for (const world::ElementSpec& child : spec.held()) {
    Json& parent = elements[name];
    if (child.plugins) {
      parent["holds"] = kind_name(*child.plugins);
    } else {
      Json& names = parent["children"];
      if (std::find(names.begin(), names.end(), child.name) == names.end()) {
        names.push_back(child.name);
      }
    }
    if (!spec.nested) add(elements, child);
  }
}

}  // namespace

const char* to_string(plugin::FileStatus status) {
  switch (status) {
    case plugin::FileStatus::loaded:
      return "loaded";
    case plugin::FileStatus::ignored:
      return "ignored";
    case plugin::FileStatus::refused:
      break;
  }
  return "refused";
}

Json world_json() {
  Json elements = Json::object();
  add(elements, world::vocabulary());
  return elements;
}

Json plugin_json(const plugin::Host& host, const Declaration& plugin) {
  Json json{{"kind", kind_name(plugin.kind)},
            {"name", plugin.name},
            {"version", plugin.version},
            {"description", plugin.description},
            {"library", host.file_of(plugin.kind, plugin.name).string()}};
  json["parameters"] = to_json(plugin.parameters);
  json["elements"] = to_json(plugin.elements);
  json["default_elements"] = Json::array();
  for (const auto& value : plugin.default_elements) {
    json["default_elements"].push_back(to_json(value));
  }
  json["holds_behaviors"] = static_cast<bool>(plugin.hold);
  const auto kinds = [](const std::vector<ReadingDeclaration>& readings) {
    Json names = Json::array();
    for (const auto& reading : readings) {
      names.push_back(reading.kind);
    }
    return names;
  };
  json["needs"] = kinds(plugin.needs);
  json["produces"] = kinds(plugin.produces);
  json["fields"] = Json::array();
  for (const ReadingDeclaration& reading : plugin.produces) {
    for (const FieldDeclaration& field : reading.fields) {
      json["fields"].push_back({{"name", field.path()},
                                {"unit", field.unit},
                                {"array", field.is_array || !field.group.empty()},
                                {"picture", field.type == FieldType::picture}});
    }
  }
  json["published"] = Json::array();
  for (const PublishedNumber& number : plugin.published) {
    json["published"].push_back(
        {{"name", number.name}, {"unit", number.facts.unit}, {"meaning", number.facts.meaning}});
  }
  json["reacts_to"] = plugin.reacts_to;
  json["events"] = Json::array();
  for (const auto& event : plugin.events) {
    json["events"].push_back({{"name", event.name}, {"meaning", event.meaning}});
  }
  return json;
}

Json plugins_json(const plugin::Host& host) {
  Json json;
  json["plugins"] = Json::array();
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* declaration : host.all(kind)) {
      json["plugins"].push_back(plugin_json(host, *declaration));
    }
  }
  json["engines"] = plugin::engine_names();
  json["directories"] = Json::array();
  for (const plugin::DirectoryReport& directory : host.report().directories) {
    Json files = Json::array();
    for (const plugin::FileReport& file : directory.files) {
      files.push_back({{"path", file.path.string()},
                       {"status", to_string(file.status)},
                       {"abi", file.abi_word},
                       {"message", file.sentence}});
    }
    json["directories"].push_back({{"path", directory.directory.path.string()},
                                   {"origin", directory.directory.origin},
                                   {"problem", directory.problem},
                                   {"files", files}});
  }
  return json;
}

Json events_json(const plugin::Host& host) {
  Json json{{"simulator", Json::array()}, {"plugins", Json::array()}};
  for (const auto& event : events::of_simulator()) {
    json["simulator"].push_back({{"name", event.name},
                                 {"meaning", event.meaning},
                                 {"detail", event.detail},
                                 {"perceived", event.is_perceived}});
  }
  for (const PluginKind kind : plugin::kPluginKinds) {
    for (const Declaration* declaration : host.all(kind)) {
      for (const auto& event : declaration->events) {
        json["plugins"].push_back(
            {{"name", event.name}, {"plugin", declaration->name}, {"meaning", event.meaning}});
      }
    }
  }
  return json;
}

}  // namespace elsie::reference
