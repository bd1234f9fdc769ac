// Shared by the subcommands of the program.
#pragma once

#include <functional>

#include "elsie/base/error.h"

namespace CLI {
class App;
}

namespace elsie::program {

using base::BadInput;
using base::kBadInput;
using base::kGoalMissed;
using base::kOtherFailure;
using base::kPluginFailed;
using base::kSuccess;

/// The hidden subcommand of workers, which `elsie batch` starts.
inline constexpr const char* kWorkerCommand = "batch-worker";
/// The hidden subcommand of the processes that are copied for workers.
inline constexpr const char* kTemplateCommand = "batch-template";

/// The hidden subcommand that loads a plugin's file, to see whether that ends: FILE, its name for
/// the user, the longest time in s.
inline constexpr const char* kLoadCommand = "load-plugin";

/// The work of the chosen subcommand; returns the exit code.
using Job = std::function<int()>;

// Each adds its subcommand to the program, which sets `job` when it is chosen.
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
void add_page_command(CLI::App& program, Job& job);
void add_explain_command(CLI::App& program, Job& job);
void add_report_command(CLI::App& program, Job& job);
void add_test_plugin_command(CLI::App& program, Job& job);
void add_train_command(CLI::App& program, Job& job);
void add_new_command(CLI::App& program, Job& job);
void add_build_command(CLI::App& program, Job& job);
void add_python_command(CLI::App& program, Job& job);
void add_manual_command(CLI::App& program, Job& job);
void add_completion_command(CLI::App& program, Job& job);
void add_session_command(CLI::App& program, Job& job);

}  // namespace elsie::program
