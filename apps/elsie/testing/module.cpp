// The exports of lib/elsie/elsie-testing.so.
#include "elsie/api/abi.h"

#include "command_module.h"

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);

extern "C" [[gnu::visibility("default")]] const elsie::program::CommandModule*
elsie_command_module() {
  using namespace elsie;
  static const program::CommandModule module{.name = program::kTestingModule,
                                             .add_commands = program::add_test_plugin_command};
  return &module;
}
