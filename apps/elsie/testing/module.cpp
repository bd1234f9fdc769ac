// The exports of lib/elsie/elsie-testing.so.
#include "command_module.h"

ELSIE_EXPORT_COMMANDS(.name = elsie::program::kTestingModule,
                      .add_commands = elsie::program::add_test_plugin_command);
