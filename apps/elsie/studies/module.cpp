// The exports of lib/elsie/elsie-studies.so.
#include "elsie/api/abi.h"
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

ELSIE_EMIT_ABI_NOTE_(ELSIE_ABI_WORD);

extern "C" [[gnu::visibility("default")]] const elsie::program::CommandModule*
elsie_command_module() {
  using namespace elsie;
  static const program::CommandModule module{.name = program::kStudiesModule,
                                             .add_commands = program::add_commands,
                                             .work = batch::work,
                                             .stand_by = batch::stand_by};
  return &module;
}
