// The exports of lib/elsie/elsie-session.so.
#include "command_module.h"

extern "C" [[gnu::visibility("default")]] const elsie::program::CommandModule*
elsie_command_module() {
  using namespace elsie;
  static const program::CommandModule module{.add_commands = program::add_session_command};
  return &module;
}
