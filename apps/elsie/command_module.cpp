#include "command_module.h"

#include <filesystem>

#include "elsie/plugin/engine_libraries.h"

namespace elsie::program {

const CommandModule& command_module() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  using Get = const CommandModule* (*)();
  const auto get = reinterpret_cast<Get>(plugin::part_symbol(
      "subcommands", program.parent_path() / "elsie-commands.so", kCommandModule));
  return *get();
}

}  // namespace elsie::program
