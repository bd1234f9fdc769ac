// The exports of lib/elsie/elsie-commands.so.
#include <CLI/CLI.hpp>

#include "elsie/render/world_cameras.h"

#include "command_module.h"
#include "make_views.h"

namespace elsie::program {

namespace {

void add_commands(CLI::App& program, Job& job) {
  describe_formats(*program.get_subcommand("run"));
  add_explain_command(program, job);
  add_check_command(program, job);
  add_picture_command(program, job);
  add_plugins_command(program, job);
  add_describe_command(program, job);
  add_schema_command(program, job);
  add_fuzzy_command(program, job);
  add_train_command(program, job);
  add_new_command(program, job);
  add_build_command(program, job);
  add_manual_command(program, job);
  add_completion_command(program, job);
}

}  // namespace

}  // namespace elsie::program

ELSIE_EXPORT_COMMANDS(.name = elsie::program::kCommandsModule,
                      .add_commands = elsie::program::add_commands,
                      .make_views = elsie::program::make_views,
                      .make_cameras = elsie::render::world_cameras);
