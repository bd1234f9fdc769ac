#include "command_module.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/error.h"
#include "elsie/base/words.h"
#include "elsie/plugin/engine_libraries.h"

namespace elsie::program {

namespace {

std::filesystem::path file_of(const char* name) {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path() / (std::string(name) + ".so");
}

/// A library that a build may lack, with its subcommands.
struct Optional {
  const char* name;
  std::vector<std::string> commands;
};

const std::array<Optional, 3>& optional_modules() {
  static const std::array<Optional, 3> modules{
      {{kStudiesModule, {"batch", "replay", "merge", "report"}},
       {kTestingModule, {"test-plugin"}},
       {kSessionModule, {"session"}}}};
  return modules;
}

/// The library that has this subcommand; null for those that every build has.
const Optional* owner_of(const std::string& command) {
  for (const Optional& module : optional_modules()) {
    if (std::find(module.commands.begin(), module.commands.end(), command) !=
        module.commands.end()) {
      return &module;
    }
  }
  return nullptr;
}

bool has(const CLI::App& program, const std::string& command) {
  const auto all = program.get_subcommands({});
  return std::any_of(all.begin(), all.end(),
                     [&](const CLI::App* each) { return each->get_name() == command; });
}

/// These describe the subcommands of all libraries.
bool describes_all(const std::string& command) {
  return command == "manual" || command == "completion";
}

/// Adds the subcommands of a library that is in order; otherwise says what is wrong with it.
bool add(const char* name, CLI::App& program, Job& job) {
  if (!std::filesystem::exists(file_of(name))) {
    return false;
  }
  try {
    command_module(name).add_commands(program, job);
    return true;
  } catch (const base::Error& error) {
    std::cerr << error.message() << '\n';
    return false;
  }
}

}  // namespace

const CommandModule& command_module(const char* name) {
  const std::filesystem::path file = file_of(name);
  using Get = const CommandModule* (*)();
  const auto get = reinterpret_cast<Get>(plugin::part_symbol("subcommands", file, kCommandModule));
  const CommandModule& module = *get();
  if (module.name != std::string(name)) {
    throw base::Error("'" + file.string() + "' is another library, '" + module.name +
                      ".so'\nreinstall Elsie, or delete the file and build it again");
  }
  return module;
}

std::vector<std::string> add_module_commands(CLI::App& program, Job& job,
                                             const std::string& chosen) {
  if (const Optional* const owner = owner_of(chosen)) {
    if (const auto file = file_of(owner->name); !std::filesystem::exists(file)) {
      throw BadInput("`elsie " + chosen + "` is not built: '" + file.string() +
                     "' is not there\n`make demo` builds only a part of the program; run `make "
                     "program`, or install Elsie again");
    }
    command_module(owner->name).add_commands(program, job);
    return {};
  }
  command_module(kCommandsModule).add_commands(program, job);
  if (has(program, chosen) && !describes_all(chosen)) {
    return {};
  }
  std::vector<std::string> missing;
  for (const auto& [name, commands] : optional_modules()) {
    // The session is for windows: the help does not list it.
    if (!add(name, program, job) && name != kSessionModule) {
      missing.insert(missing.end(), commands.begin(), commands.end());
    }
  }
  if (!missing.empty()) {
    program.footer(program.get_footer() + "\n\nNot built: " + base::joined(missing) +
                   "; `make program` builds them.");
  }
  return missing;
}

}  // namespace elsie::program
