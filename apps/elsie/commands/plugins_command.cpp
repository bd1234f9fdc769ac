// elsie plugins and elsie describe: list the plugins, and describe one of them.
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <set>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "elsie/base/near_name.h"
#include "elsie/base/words.h"
#include "elsie/experiment/vocabulary.h"
#include "elsie/plugin/engine_libraries.h"
#include "elsie/plugin/kind_name.h"
#include "elsie/reference/json.h"
#include "elsie/reference/reference.h"
#include "elsie/world/vocabulary.h"

#include "command.h"
#include "environment.h"
#include "streams.h"

namespace elsie::program {

namespace {

using elsie::Declaration;
using elsie::PluginKind;
using nlohmann::ordered_json;
using plugin::DirectoryReport;
using plugin::FileReport;
using plugin::Host;
using plugin::kind_name;
using plugin::kPluginKinds;

struct PluginsOptions {
  PluginOptions plugins;
  bool check = false;
  bool json = false;
  bool names = false;
};

struct DescribeOptions {
  PluginOptions plugins;
  std::string name;
  std::optional<PluginKind> kind;  // of several plugins of that name; default: all
  bool json = false;
  bool declaration = false;
};

/// The elements that a plugin's element may contain: "<suppress>, <inhibit>".
std::string contents_of(const Declaration& plugin) {
  std::string list;
  const auto add = [&list](const std::string& name) {
    list += (list.empty() ? "<" : ", <") + name + ">";
  };
  for (const auto& element : plugin.elements) {
    add(element.name);
  }
  if (plugin.hold) {
    add("behaviors");
    add("coordinator");
  }
  return list;
}

void print_list(const Host& host) {
  std::size_t width = 0;
  for (const PluginKind kind : kPluginKinds) {
    for (const Declaration* plugin : host.all(kind)) {
      width = std::max(width, plugin->name.size());
    }
  }
  for (const PluginKind kind : kPluginKinds) {
    out() << kind_name(kind) << "s\n";
    for (const Declaration* plugin : host.all(kind)) {
      out() << "  " << plugin->name << std::string(width + 2 - plugin->name.size(), ' ')
            << plugin->description << '\n';
      if (const std::string contents = contents_of(*plugin); !contents.empty()) {
        out() << std::string(width + 4, ' ') << "holds " << contents << '\n';
      }
    }
  }
  out() << "engines, for <physics engine=\"...\">\n";
  for (const std::string& engine : plugin::engine_names()) out() << "  " << engine << '\n';
}

void print_check(const Host& host) {
  for (const DirectoryReport& directory : host.report().directories) {
    out() << directory.directory.path.string() << " (" << directory.directory.origin << ")"
          << (directory.problem.empty() ? "" : ": " + directory.problem) << '\n';
    for (const FileReport& file : directory.files) {
      out() << "  " << file.path.filename().string() << ": " << reference::to_string(file.status);
      if (!file.sentence.empty()) {
        out() << ": " << file.sentence;
      }
      const char* separator = ": ";
      for (const auto& plugin : file.plugins) {
        out() << separator << kind_name(plugin.kind) << ' ' << plugin.name << ' ' << plugin.version;
        if (!plugin.shadowed_by.empty()) {
          out() << " (not used: " << plugin.shadowed_by.string() << " has one of that name)";
        }
        separator = ", ";
      }
      out() << '\n';
    }
  }
}

void print(const ordered_json& json) {
  data_out() << json.dump(2, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

void print_names(const Host& host) {
  for (const PluginKind kind : kPluginKinds) {
    for (const Declaration* plugin : host.all(kind)) {
      out() << plugin->name << '\n';
    }
  }
}

int plugins(const PluginsOptions& options) {
  const Host host = load_plugins(options.plugins);
  if (options.json) {
    print(reference::plugins_json(host));
  } else if (options.names) {
    print_names(host);
  } else {
    options.check ? print_check(host) : print_list(host);
  }
  return kSuccess;
}

int describe(const DescribeOptions& options) {
  if (options.name == "world" || options.name == "experiment") {
    if (options.json) {
      throw BadInput("--json is for plugins and events, but '" + options.name +
                     "' is a kind of file; `elsie schema " + options.name + "` prints its schema");
    }
    out() << (options.name == "world" ? reference::world_reference()
                                      : experiment::experiment_reference());
    return kSuccess;
  }
  const Host host = load_plugins(options.plugins);
  if (options.name == "events") {
    if (options.json) {
      print(reference::events_json(host));
    } else {
      out() << reference::events_reference(host);
    }
    return kSuccess;
  }
  bool found = false;
  std::vector<std::string> names;
  std::string elements;  // of that name
  if (!options.kind && !options.json && !options.declaration) {
    std::set<std::string> of_elements;
    for (const world::ElementSpec* root : {&world::vocabulary(), &experiment::vocabulary()}) {
      elements += reference::element_reference(*root, options.name);
      reference::list_elements(*root, of_elements);
    }
    names.assign(of_elements.begin(), of_elements.end());
  }
  ordered_json all = ordered_json::array();
  for (const PluginKind kind : kPluginKinds) {
    if (options.kind && kind != *options.kind) {
      continue;
    }
    for (const Declaration* plugin : host.all(kind)) {
      names.push_back(plugin->name);
    }
    if (const Declaration* plugin = host.find(kind, options.name)) {
      found = true;
      if (options.json) {
        all.push_back(reference::plugin_json(host, *plugin));
      } else {
        out() << (options.declaration ? reference::plugin_declaration(*plugin)
                                      : reference::plugin_reference(*plugin));
      }
    }
  }
  if (!found && elements.empty()) {
    throw BadInput("there is no " +
                   std::string(options.kind ? kind_name(*options.kind) : "plugin") + " '" +
                   options.name + "'" + base::did_you_mean(options.name, names) +
                   "\n`elsie plugins` lists all that were found");
  }
  out() << (found ? elements : elements.substr(elements.find_first_not_of('\n')));
  if (options.json) {
    print(all.size() == 1 ? all[0] : all);
  }
  return kSuccess;
}

}  // namespace

void add_plugins_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand("plugins", "List the plugins that were found");
  command->footer(
      "\nExamples:\n  elsie plugins\n"
      "  elsie plugins --check --plugin-path build/my_plugins\n  elsie plugins --json\n");
  auto options = std::make_shared<PluginsOptions>();
  command->add_flag("--check", options->check,
                    "Show for every file in every directory what it is, or why it was refused");
  command->add_flag("--json", options->json, "Print everything as one JSON object");
  command->add_flag("--names", options->names, "Print the names alone, a line each");
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return plugins(*options); }; });
}

namespace {

PluginKind kind_of(const std::string& word) {
  for (const PluginKind kind : kPluginKinds) {
    if (word == kind_name(kind)) {
      return kind;
    }
  }
  if (word == "behaviour") {
    return PluginKind::behavior;
  }
  std::vector<std::string> kinds;
  for (const PluginKind kind : kPluginKinds) {
    kinds.emplace_back(kind_name(kind));
  }
  throw BadInput("'" + word + "' is not a kind of plugins; there are " + base::listed(kinds));
}

}  // namespace

void add_describe_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "describe", "Describe a plugin, all events, or the vocabulary of world or experiment files");
  command->footer(
      "\nOf a plugin it prints what it does, its parameters with defaults and ranges, the elements "
      "that may be inside of its own, and its events.\n"
      "\nExamples:\n  elsie describe beam_range\n  elsie describe reach\n  elsie describe world\n"
      "  elsie describe experiment\n"
      "  elsie describe events\n"
      "  elsie describe behavior wander --declaration\n");
  auto options = std::make_shared<DescribeOptions>();
  command
      ->add_option_function<std::vector<std::string>>(
          "NAME",
          [options](const std::vector<std::string>& words) {
            options->name = words.back();
            if (words.size() == 2) options->kind = kind_of(words.front());
          },
          "Name of a plugin, or of an element of world and experiment files, as 'reach'; or "
          "'events', 'world' or 'experiment'. The kind of the plugin may stand before it: 'sensor "
          "compass'")
      ->expected(1, 2)
      ->type_name("[KIND] NAME")
      ->required();
  CLI::Option* json =
      command->add_flag("--json", options->json, "Print one JSON object, and nothing else");
  command
      ->add_flag("--declaration", options->declaration,
                 "Print it without a title: what a page of docs/ has between its marks")
      ->excludes(json);
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return describe(*options); }; });
}

}  // namespace elsie::program
