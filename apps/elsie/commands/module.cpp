// The exports of lib/elsie/elsie-commands.so.
#include <CLI/CLI.hpp>

#include "elsie/batch/worker.h"
#include "elsie/render/world_cameras.h"

#include "command_module.h"
#include "make_views.h"

namespace elsie::program {

namespace {

/// In the order in which the help lists them, after `elsie run`.
void add_commands(CLI::App& program, Job& job) {
  describe_formats(*program.get_subcommand("run"));
  for (const auto add : {add_explain_command,    add_page_command,        add_check_command,
                         add_batch_command,      add_replay_command,      add_report_command,
                         add_merge_command,      add_picture_command,     add_plugins_command,
                         add_describe_command,   add_schema_command,      add_new_command,
                         add_build_command,      add_test_plugin_command, add_train_command,
                         add_fuzzy_command,      add_python_command,      add_manual_command,
                         add_completion_command, add_session_command}) {
    add(program, job);
  }
}

}  // namespace

}  // namespace elsie::program

// The ABI word is compared before the library is loaded.
ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);

extern "C" [[gnu::visibility("default")]] const elsie::program::CommandModule*
elsie_command_module() {
  static const elsie::program::CommandModule module{.add_commands = elsie::program::add_commands,
                                                    .make_views = elsie::program::make_views,
                                                    .make_cameras = elsie::render::world_cameras,
                                                    .work = elsie::batch::work,
                                                    .stand_by = elsie::batch::stand_by};
  return &module;
}
