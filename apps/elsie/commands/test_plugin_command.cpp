// elsie test-plugin: tries plugins on random input and reports their faults.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <sys/resource.h>
#include <unistd.h>

#include "elsie/base/near_name.h"
#include "elsie/build/source_build.h"
#include "elsie/plugin/declared_element.h"
#include "elsie/plugin/error.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/process/crash_report.h"
#include "elsie/testing/checker.h"
#include "elsie/world/markup.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "streams.h"

namespace elsie::program {

namespace {

namespace fs = std::filesystem;
using elsie::Declaration;
using elsie::ParameterDeclaration;
using elsie::PluginKind;
using plugin::kPluginKinds;
using testing::CheckOptions;
using testing::Plugins;

struct TestPluginOptions {
  PluginOptions plugins;
  std::vector<std::string> names;
  std::vector<std::string> settings;
  std::vector<std::string> elements;
  std::vector<std::string> members;
  std::uint64_t seed = 1;
  int variants = CheckOptions().variants;
  double time_limit_s = 20.0;
  double memory_limit_mb = 1000.0;
};

/// Limits the memory that plugins may add; larger requests throw std::bad_alloc. Limits the address
/// space, because large blocks are mapped.
void limit_memory(double megabytes) {
  std::ifstream statistics("/proc/self/statm");
  std::uint64_t pages = 0;
  statistics >> pages;
  const rlim_t most = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) +
                      static_cast<rlim_t>(1e6 * megabytes);
  rlimit limit{};
  if (statistics && getrlimit(RLIMIT_AS, &limit) == 0) {
    limit.rlim_cur = std::min(limit.rlim_max, most);
    setrlimit(RLIMIT_AS, &limit);
  }
}

/// True if the name is that of a library or source rather than a plugin.
bool is_file(const std::string& name) {
  return name.find('.') != std::string::npos || name.find('/') != std::string::npos;
}

elsie::ParameterValue value_of(const ParameterDeclaration& parameter, const std::string& text,
                               const std::string& where) {
  const plugin::Parsed parsed = plugin::parse_value(parameter, text);
  if (!parsed.value) throw BadInput(where + ": expected " + parsed.expected);
  return *parsed.value;
}

/// The settings that are parameters of this plugin; `used` counts them.
testing::Settings settings_for(const Declaration& declaration, const TestPluginOptions& options,
                               std::map<std::string, bool>& used) {
  testing::Settings settings;
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) {
      throw BadInput("--set: expected NAME=VALUE, found '" + setting + "'");
    }
    const std::string name = setting.substr(0, equals);
    used.emplace(name, false);
    for (const ParameterDeclaration& parameter : declaration.parameters) {
      if (parameter.name == name) {
        settings[name] = value_of(parameter, setting.substr(equals + 1), "--set " + setting);
        used[name] = true;
      }
    }
  }
  return settings;
}

/// The value of an element, with what stands in it.
elsie::ElementValue value_of(const plugin::DeclaredElement& declared,
                             const world::Element& element) {
  elsie::ElementValue value{element.name, {}};
  for (const world::Attribute& attribute : element.attributes) {
    const auto* const parameter = plugin::find_declared(declared.parameters(), attribute.name);
    const std::string where = "--element " + world::in_words(attribute, element);
    if (!parameter) throw BadInput(where + ": <" + element.name + "> has no such attribute");
    value.parameters[attribute.name] = value_of(*parameter, attribute.value, where);
  }
  for (const world::Element& inner : element.children) {
    const auto known = declared.inside(inner.name);
    if (!known) {
      throw BadInput("--element: <" + element.name + "> may not hold <" + inner.name + ">");
    }
    value.elements.push_back(value_of(*known, inner));
  }
  return value;
}

/// The elements that may stand in that of this plugin; `used` counts them.
testing::Elements elements_for(const Declaration& declaration, const TestPluginOptions& options,
                               std::map<std::string, bool>& used) {
  testing::Elements elements;
  for (const std::string& text : options.elements) {
    const world::Element element = world::parse_markup(text, "--element");
    used.emplace(element.name, false);
    const auto declared = plugin::DeclaredElement(declaration).inside(element.name);
    if (!declared) continue;
    used[element.name] = true;
    elements.push_back(value_of(*declared, element));
  }
  return elements;
}

/// The plugins that an argument names: those of a library, or those with a name.
std::vector<const Declaration*> chosen(const Plugins& plugins, const std::string& name) {
  std::vector<const Declaration*> all;
  std::vector<std::string> names;
  const fs::path library = build::is_source(name) ? compiled(name).library : fs::path(name);
  for (const PluginKind kind : kPluginKinds) {
    for (const Declaration* declaration : plugins.host().all(kind)) {
      std::error_code error;
      const bool is_meant =
          is_file(name)
              ? fs::equivalent(plugins.host().file_of(kind, declaration->name), library, error)
              : declaration->name == name;
      if (is_meant) {
        all.push_back(declaration);
      }
      names.push_back(declaration->name);
    }
  }
  if (all.empty()) {
    throw BadInput("there is no plugin '" + name + "'" + base::did_you_mean(name, names) +
                   "\n`elsie plugins` lists all that were found");
  }
  return all;
}

int test_plugins(TestPluginOptions options) {
  for (const std::string& name : options.names) {
    if (is_file(name)) {
      options.plugins.files.push_back(name);
    }
  }
  std::size_t wrong = 0;
  try {
    const LoadingLimit limit(
        options.time_limit_s);  // covers all calls until the libraries are unloaded
    const Plugins plugins(load_plugins(options.plugins, std::nullopt));
    limit_memory(options.memory_limit_mb);
    std::vector<std::pair<const Declaration*, CheckOptions>> jobs;
    std::map<std::string, bool> used, used_elements;
    for (const std::string& name : options.names) {
      for (const Declaration* declaration : chosen(plugins, name)) {
        CheckOptions how;
        how.settings = settings_for(*declaration, options, used);
        how.elements = elements_for(*declaration, options, used_elements);
        how.members = options.members;
        how.seed = options.seed;
        how.variants = options.variants;
        how.memory_limit = static_cast<std::size_t>(0.5e6 * options.memory_limit_mb);
        jobs.emplace_back(declaration, std::move(how));
      }
    }
    for (const auto& [name, was_used] : used) {
      if (!was_used) {
        throw BadInput("--set " + name + ": none of these plugins has a parameter of that name");
      }
    }
    for (const auto& [name, was_used] : used_elements) {
      if (!was_used) {
        throw BadInput("--element: none of these plugins has an element <" + name + "> in its own");
      }
    }
    for (const auto& [declaration, how] : jobs) {
      const auto findings = check_plugin(declaration->kind, declaration->name, how, plugins);
      for (const std::string& finding : findings) {
        out() << finding << std::endl;
      }
      if (findings.empty()) {
        out() << plugin::kind_name(declaration->kind) << " '" << declaration->name
              << "': no faults found" << std::endl;
      }
      wrong += findings.empty() ? 0 : 1;
    }
  } catch (const plugin::PluginError& error) {
    throw BadInput(error.what());
  }
  return wrong == 0 ? kSuccess : kGoalMissed;
}

}  // namespace

void add_test_plugin_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("test-plugin", "Check a plugin by trying it on random input");
  command->footer(
      "\nIt checks the declaration, finite answers, no shared state, the same answers on the same "
      "input, and no growth of memory.\n"
      "\nExamples:\n  elsie test-plugin wander\n  elsie test-plugin build/shy.so shy.cpp\n"
      "  elsie test-plugin fusion_context_blending --set model=my.fcl --members "
      "avoid_obstacle,wander\n"
      "  elsie test-plugin referee --element '<after time=\"10\"/>'\n"
      "\nExit codes: 0 no faults found; 1 faults found; 2 bad input or usage; 3 a plugin crashed, "
      "and is named.");
  auto options = std::make_shared<TestPluginOptions>();
  command
      ->add_option("PLUGIN", options->names,
                   "Names of plugins, library files, sources of one file, or scripts (.py)")
      ->required();
  command->add_option("--set", options->settings, "Fix a parameter, NAME=VALUE; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--element", options->elements,
                   "An element inside the plugin's own, as in a world; may be repeated")
      ->allow_extra_args(false);
  command
      ->add_option("--members", options->members,
                   "Ids of the behaviours of a coordinator that accepts no others")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--seed", options->seed, "Seed of the random input")->capture_default_str();
  command->add_option("--variants", options->variants, "How many sets of random parameters to try")
      ->check(whole_number(0, 1000000))
      ->capture_default_str();
  command
      ->add_option("--time-limit", options->time_limit_s,
                   "Stop the check, and name the plugin, when one call takes longer than this")
      ->check(positive_number())
      ->type_name("SECONDS")
      ->capture_default_str();
  command
      ->add_option("--memory-limit", options->memory_limit_mb,
                   "How much memory the plugins may take in all; a plugin that grows to half of it "
                   "is a finding")
      ->check(number_between(50.0, 1e6))
      ->type_name("MB")
      ->capture_default_str();
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return test_plugins(*options); }; });
}

}  // namespace elsie::program
