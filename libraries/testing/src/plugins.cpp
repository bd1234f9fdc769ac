#include "elsie/testing/plugins.h"

#include <algorithm>
#include <optional>
#include <system_error>
#include <utility>

#include "elsie/build/source_build.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/world/data_directories.h"

namespace elsie::testing {
namespace {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path();
}

/// A place that the caller names must be usable.
void require_loaded(const plugin::DirectoryReport& place) {
  if (!place.problem.empty()) {
    throw plugin::PluginError(place.directory.origin + ": " + place.problem);
  }
  for (const plugin::FileReport& file : place.files) {
    if (!fs::is_directory(place.directory.path) && file.status != plugin::FileStatus::loaded) {
      throw plugin::PluginError(place.directory.origin + ": " + file.sentence);
    }
  }
}

plugin::Host load(const std::vector<fs::path>& given) {
  std::vector<plugin::SearchDirectory> places;
  for (const fs::path& place : given) {
    const bool is_source = build::is_source(place);
    places.push_back({is_source ? build::build_source(place).library : place, place.string(),
                      is_source ? place : fs::path()});
  }
  // The test's own plugins are usually next to it; they come before installed ones.
  bool has_own = false;
  for (plugin::SearchDirectory& directory : plugin::default_search_path()) {
    if (!has_own && directory.origin != plugin::kPluginPathVariable) {
      places.push_back({program_folder(), "next to the test program"});
      has_own = true;
    }
    places.push_back(std::move(directory));
  }
  plugin::Host host(std::move(places));
  for (std::size_t i = 0; i < given.size(); ++i) {
    require_loaded(host.report().directories[i]);
  }
  return host;
}

std::optional<std::string> find_file(const std::string& name) {
  std::error_code error;
  if (fs::is_regular_file(name, error)) {
    return name;
  }
  if (fs::path(name).is_absolute()) {
    return std::nullopt;
  }
  for (const std::string& directory : data_directories()) {
    const fs::path file = fs::path(directory) / name;
    if (fs::is_regular_file(file, error)) {
      return file.string();
    }
  }
  return std::nullopt;
}

std::string places_searched() {
  std::string text = "the working directory";
  for (const std::string& directory : data_directories()) {
    text += ", " + directory;
  }
  return text;
}

[[noreturn]] void refuse_file(const std::string& whose, const std::string& parameter,
                              const std::string& file) {
  throw plugin::PluginError(whose + ": the file '" + file + "' of its parameter '" + parameter +
                            "' is not there; looked in " + places_searched());
}

Settings complete(const std::string& whose, const std::vector<ParameterDeclaration>& parameters,
                  Settings settings, bool with_defaults) {
  for (const ParameterDeclaration& parameter : parameters) {
    auto given = settings.find(parameter.name);
    if (given == settings.end()) {
      if (parameter.facts.required) {
        throw plugin::PluginError(whose + ": its parameter '" + parameter.name +
                                  "' has no default, and must be given");
      }
      if (!with_defaults || parameter.type != ParameterType::file) {
        continue;
      }
      given = settings.emplace(parameter.name, parameter.default_value).first;
    }
    ParameterValue& value = given->second;
    if (parameter.type == ParameterType::real && std::holds_alternative<std::int64_t>(value)) {
      value = static_cast<double>(std::get<std::int64_t>(value));
    }
    if (parameter.type == ParameterType::file && std::holds_alternative<std::string>(value)) {
      std::string& file = std::get<std::string>(value);
      if (file.empty()) {
        continue;
      }
      const auto found = find_file(file);
      if (!found) {
        refuse_file(whose, parameter.name, file);
      }
      file = *found;
    }
  }
  return settings;
}

std::string title(const Declaration& declaration) {
  return std::string(plugin::kind_name(declaration.kind)) + " '" + declaration.name + "'";
}

void complete(const std::string& plugin, const plugin::DeclaredElement& around,
              Elements& elements) {
  for (ElementValue& element : elements) {
    const auto declared = around.inside(element.element);
    if (!declared) continue;  // apply_parameters() reports the mistake
    element.parameters = complete(plugin + ", element '" + element.element + "'",
                                  declared->parameters(), element.parameters, false);
    complete(plugin, *declared, element.elements);
  }
}

}  // namespace

Plugins::Plugins() : Plugins(std::vector<fs::path>()) {}
Plugins::Plugins(std::initializer_list<fs::path> places) : Plugins(std::vector<fs::path>(places)) {}
Plugins::Plugins(const std::vector<fs::path>& places) : Plugins(load(places)) {}
Plugins::Plugins(plugin::Host host)
    : host_(std::make_shared<const plugin::Host>(std::move(host))) {}

const Plugins& Plugins::found() {
  static const Plugins plugins;
  return plugins;
}

const Declaration& Plugins::declaration(PluginKind kind, const std::string& name) const {
  const Declaration* const declaration = host_->find(kind, name);
  if (!declaration) {
    throw plugin::PluginError(host_->explain_missing(kind, name));
  }
  return *declaration;
}

Settings Plugins::completed(const Declaration& declaration, const Settings& settings) const {
  return complete(title(declaration), declaration.parameters, settings, true);
}

Elements Plugins::completed(const Declaration& declaration, const Elements& elements) const {
  Elements all = elements;
  complete(title(declaration), plugin::DeclaredElement(declaration), all);
  return all;
}

std::vector<std::string> data_directories() { return world::default_data_directories(); }

}  // namespace elsie::testing
