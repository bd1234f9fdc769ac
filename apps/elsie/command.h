// What the subcommands of the program have in common.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace CLI {
class App;
}

/// What the program tells the shell.
enum ExitCode {
  kSuccess = 0,
  kGoalMissed = 1,    // the run ended without reaching its goal
  kBadInput = 2,      // bad input or usage
  kPluginFailed = 3,  // a plugin failed while running
  kOtherFailure = 4,  // anything else: a full disk, an interrupt
};

/// The one word on the command line of a worker, which `elsie batch` starts; for no user.
inline constexpr const char* kWorkerCommand = "batch-worker";

/// Input that the program cannot work with; what() is a sentence for the user. Ends the program
/// with kBadInput.
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The work of the chosen subcommand; returns the exit code.
using Job = std::function<int()>;

// Each adds its subcommand to the program; when that is chosen, `job` becomes its work.
void add_run_command(CLI::App& program, Job& job);
void add_check_command(CLI::App& program, Job& job);
void add_plugins_command(CLI::App& program, Job& job);
void add_describe_command(CLI::App& program, Job& job);
void add_schema_command(CLI::App& program, Job& job);
void add_picture_command(CLI::App& program, Job& job);
void add_fuzzy_command(CLI::App& program, Job& job);
void add_batch_command(CLI::App& program, Job& job);
void add_merge_command(CLI::App& program, Job& job);
void add_replay_command(CLI::App& program, Job& job);
void add_explain_command(CLI::App& program, Job& job);
void add_report_command(CLI::App& program, Job& job);
void add_test_plugin_command(CLI::App& program, Job& job);
void add_train_command(CLI::App& program, Job& job);
void add_new_command(CLI::App& program, Job& job);
void add_build_command(CLI::App& program, Job& job);
void add_manual_command(CLI::App& program, Job& job);
void add_completion_command(CLI::App& program, Job& job);
