#include "command_module.h"

#include <filesystem>
#include <string>

#include <dlfcn.h>

#include "elsie/base/error.h"

namespace elsie::program {

namespace {

const CommandModule& load() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  const std::string file = (program.parent_path() / "elsie-commands.so").string();
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

}  // namespace

const CommandModule& command_module() {
  static const CommandModule& module = load();
  return module;
}

}  // namespace elsie::program
