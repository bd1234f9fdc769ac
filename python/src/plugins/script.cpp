// Loads scripts: the dicts of elsie/plugins.py become declarations.
#include "script.h"

#include <map>
#include <stdexcept>
#include <utility>

#include <pybind11/stl.h>

#include "elsie/api/disturbance.h"
#include "elsie/base/error.h"
#include "elsie/plugin/script.h"

#include "kinds.h"
#include "scripted.h"
#include "struct_layout.h"

namespace elsie::python {
namespace {

ParameterType type_of(const std::string& name) {
  static const std::map<std::string, ParameterType> types{
      {"real", ParameterType::real},       {"integer", ParameterType::integer},
      {"boolean", ParameterType::boolean}, {"text", ParameterType::text},
      {"file", ParameterType::file},       {"reals", ParameterType::reals}};
  return types.at(name);
}

Scripted& scripted(Component& object) { return dynamic_cast<Scripted&>(object); }
const Scripted& scripted(const Component& object) { return dynamic_cast<const Scripted&>(object); }

ParameterDeclaration parameter_of(const py::dict& facts) {
  ParameterDeclaration parameter;
  parameter.name = facts["name"].cast<std::string>();
  parameter.type = type_of(facts["type"].cast<std::string>());
  parameter.facts = {.unit = facts["unit"].cast<std::string>(),
                     .min = facts["min"].cast<double>(),
                     .above = facts["above"].cast<double>(),
                     .max = facts["max"].cast<double>(),
                     .choices = facts["choices"].cast<std::vector<std::string>>(),
                     .meaning = facts["meaning"].cast<std::string>(),
                     .required = facts["required"].cast<bool>(),
                     .live = facts["live"].cast<bool>()};
  parameter.default_value = value_of(parameter.type, facts["default"]);
  parameter.set = [name = parameter.name](Component& object, const ParameterValue& value) {
    scripted(object).set(name.c_str(), value);
  };
  parameter.get = [name = parameter.name, type = parameter.type](const Component& object) {
    return scripted(object).get(name.c_str(), type);
  };
  return parameter;
}

/// A kind of reading or command that is used: of any layout if only its name is given.
ReadingDeclaration used(py::handle declared) {
  if (py::len(declared.attr("fields")) > 0) return StructLayout::of(declared)->declaration();
  ReadingDeclaration declaration;
  declaration.kind = declared.attr("kind").cast<std::string>();
  return declaration;
}

HeardDeclaration heard(py::handle declared) {
  const std::shared_ptr<const StructLayout> layout = StructLayout::of(declared);
  return {layout->declaration(), [layout](const FieldVisit& change) {
            const std::shared_ptr<void> content = layout->blank();
            layout->visit(content.get(), change);
            return AnyMessage(layout->kind(), content,
                              [layout](const void* value, const FieldVisit& each) {
                                layout->visit(value, each);
                              });
          }};
}

struct Kind {
  PluginKind kind;
  std::unique_ptr<Component> (*make)(const ScriptClassRef&);
};

const Kind& kind_of(const std::string& name) {
  static const std::map<std::string, Kind> kinds{
      {"behavior", {PluginKind::behavior, make_behavior}},
      {"coordinator", {PluginKind::coordinator, make_coordinator}},
      {"sensor", {PluginKind::sensor, make_sensor}},
      {"actuator", {PluginKind::actuator, make_actuator}},
      {"measure", {PluginKind::measure, make_measure}},
      {"rule", {PluginKind::rule, make_rule}},
  };
  return kinds.at(name);
}

Declaration declaration_of(const py::dict& facts) {
  const auto text = [&](const char* name) { return facts[name].cast<std::string>(); };
  Declaration declaration;
  const Kind kind = kind_of(text("kind"));
  declaration.kind = kind.kind;
  declaration.name = text("name");
  declaration.version = text("version");
  declaration.description = text("description");
  for (const py::handle each : facts["parameters"]) {
    declaration.parameters.push_back(parameter_of(py::reinterpret_borrow<py::dict>(each)));
  }
  for (const py::handle each : facts["published"]) {
    auto [name, unit, meaning] = each.cast<std::tuple<std::string, std::string, std::string>>();
    declaration.published.push_back({name, {unit, meaning}, [name = name](const Component& object) {
                                       return scripted(object).number(name.c_str());
                                     }});
  }
  for (const py::handle each : facts["needs"]) declaration.needs.push_back(used(each));
  for (const py::handle each : facts["commands"]) declaration.commands.push_back(used(each));
  for (const py::handle each : facts["hears"]) declaration.hears.push_back(heard(each));
  for (const auto& [name, meaning] : facts["raises"].cast<py::dict>()) {
    declaration.events.push_back({name.cast<std::string>(), meaning.cast<std::string>()});
  }
  declaration.reacts_to = facts["reacts_to"].cast<std::vector<std::string>>();
  declaration.only_acts = facts["only_acts"].cast<bool>();
  declaration.feels_contacts = facts["feels_contacts"].cast<bool>();
  declaration.hears_messages = facts["hears_messages"].cast<bool>();
  declaration.may_share_threads = false;  // one interpreter
  const ScriptClassRef of =
      locked_at_end(ScriptClass{text("file"), facts["cls"], facts, facts["errstate"],
                                facts["remembers"].cast<std::vector<std::string>>()});
  declaration.create = [of, make = kind.make] { return make(of); };
  if (!facts["struct"].is_none()) {
    const std::shared_ptr<const StructLayout> layout = StructLayout::of(facts["struct"]);
    (kind.kind == PluginKind::sensor ? declaration.produces : declaration.takes)
        .push_back(layout->declaration());
    Disturbable::declare_for_all(declaration);
  }
  return declaration;
}

/// The module of a script in Python's list of modules.
struct Module {
  std::string name;
  ~Module() {
    if (name.empty()) return;
    py::module_::import("elsie.plugins").attr("_unload")(name);
  }
  explicit Module(std::string of) : name(std::move(of)) {}
  Module(Module&& other) noexcept : name(std::exchange(other.name, "")) {}
  Module& operator=(Module&&) = delete;
};

void load(const std::filesystem::path& file, plugin::Script& script) {
  const Gil gil;
  const std::string path = std::filesystem::absolute(file).string();
  try {
    const py::list all = py::module_::import("elsie.plugins").attr("_load")(path);
    for (const py::handle each : all) {
      script.declarations.push_back(declaration_of(py::reinterpret_borrow<py::dict>(each)));
    }
    if (!all.empty()) {
      script.kept = locked_at_end(
          Module(all[0].attr("__getitem__")("cls").attr("__module__").cast<std::string>()));
    }
  } catch (py::error_already_set& error) {
    script.declarations.clear();
    throw_fault(error, path);
  } catch (const py::cast_error&) {
    script.declarations.clear();
    throw std::runtime_error(file.filename().string() +
                             ": a declaration has a value of another type than expected; see "
                             "help(elsie.parameter), help(elsie.published) and help(elsie.Plugin)");
  }
}

}  // namespace

void bind_scripts(py::module_& module) {
  static const plugin::LoadScript function = load;
  module.attr("load_script") = py::capsule(reinterpret_cast<void*>(function), ELSIE_LOAD_SCRIPT);
}

}  // namespace elsie::python
