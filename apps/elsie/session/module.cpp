// The exports of lib/elsie/elsie-session.so.
#include "command_module.h"

ELSIE_EXPORT_COMMANDS(.name = elsie::program::kSessionModule,
                      .add_commands = elsie::program::add_session_command);
