#include "command_module.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <dlfcn.h>

#include "elsie/base/error.h"

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

bool has(const CLI::App& program, const std::string& command) {
  const auto all = program.get_subcommands({});
  return std::any_of(all.begin(), all.end(),
                     [&](const CLI::App* each) { return each->get_name() == command; });
}

/// These describe the subcommands of all libraries.
bool describes_all(const std::string& command) {
  return command == "manual" || command == "completion";
}

}  // namespace

const CommandModule& command_module(const char* name) {
  const std::string file = file_of(name).string();
  void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (!module) {
    throw base::Error("'" + file + "', which belongs to this program, cannot be loaded: " +
                      dlerror() + "\nreinstall Elsie, or build it again");
  }
  using Get = const CommandModule* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(module, kCommandModule));
  if (!get) {
    throw base::Error("'" + file + "' is not of this program\nreinstall Elsie, or build it again");
  }
  return *get();
}

void add_module_commands(CLI::App& program, Job& job, const std::string& chosen) {
  const auto is_found = [&] { return has(program, chosen) && !describes_all(chosen); };
  command_module(kViewsModule).add_commands(program, job);
  std::string missing;
  for (const auto& [name, commands] : optional_modules()) {
    if (is_found()) {
      return;
    }
    if (std::filesystem::exists(file_of(name))) {
      command_module(name).add_commands(program, job);
      continue;
    }
    if (std::find(commands.begin(), commands.end(), chosen) != commands.end()) {
      throw BadInput("`elsie " + chosen + "` is not built: '" + file_of(name).string() +
                     "' is not there\n`make demo` builds only a part of the program; build the "
                     "rest with `make program`");
    }
    for (const std::string& command : commands) {
      missing += (missing.empty() ? "" : ", ") + command;
    }
  }
  if (!missing.empty()) {
    program.footer(program.get_footer() + "\n\nNot built: " + missing +
                   "; `make program` builds them.");
  }
}

}  // namespace elsie::program
