#include "command_module.h"

#include "elsie/plugin/engine_libraries.h"

namespace elsie::program {

const CommandModule& command_module() {
  using Get = const CommandModule* (*)();
  const auto get = reinterpret_cast<Get>(
      plugin::part_symbol("subcommands", plugin::part_file("elsie-commands"), kCommandModule));
  return *get();
}

}  // namespace elsie::program
