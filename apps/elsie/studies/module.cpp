// The exports of lib/elsie/elsie-studies.so.
#include "elsie/batch/worker.h"

#include "command_module.h"

namespace elsie::program {

namespace {

void add_commands(CLI::App& program, Job& job) {
  add_batch_command(program, job);
  add_replay_command(program, job);
  add_merge_command(program, job);
  add_report_command(program, job);
}

}  // namespace

}  // namespace elsie::program

ELSIE_EXPORT_COMMANDS(.name = elsie::program::kStudiesModule,
                      .add_commands = elsie::program::add_commands, .work = elsie::batch::work,
                      .stand_by = elsie::batch::stand_by);
