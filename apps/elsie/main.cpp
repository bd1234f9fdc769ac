// The command-line program: elsie SUBCOMMAND ...
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "elsie/base/error.h"
#include "elsie/base/thrown.h"
#include "elsie/build/source_build.h"
#include "elsie/files/clean_text.h"
#include "elsie/process/crash_report.h"
#include "elsie/process/process_end.h"

#include "arguments.h"
#include "arithmetic.h"
#include "command.h"
#include "command_module.h"
#include "environment.h"
#include "interrupts.h"
#include "streams.h"
#include "usage.h"

namespace elsie::program {

namespace {

constexpr const char* kProgramExamples = R"(
Examples:
  elsie run worlds/clutter.xml --seed 7 --picture clutter.png
  elsie run worlds/maze.xml --set 'robot[r1]/@max_speed=0.3' --json
  elsie run worlds/clutter.xml --record clutter.mcap
  elsie explain clutter.mcap --picture clutter.png
  elsie page clutter.mcap
  elsie batch experiments/top_speed.xml
  elsie check worlds/*.xml
  elsie describe wander

Exit codes: 0 success; 1 the run ended without reaching its goal; 2 bad input or usage;
3 a plugin failed; 4 anything else.
`elsie SUBCOMMAND --help` has examples for each subcommand.)";

/// The text of a message, cleaned: names and values in it may come from files of any origin.
class CleanMessage final : public spdlog::custom_flag_formatter {
 public:
  void format(const spdlog::details::log_msg& message, const std::tm&,
              spdlog::memory_buf_t& to) override {
    const std::string text = files::clean({message.payload.data(), message.payload.size()});
    to.append(text.data(), text.data() + text.size());
  }
  std::unique_ptr<spdlog::custom_flag_formatter> clone() const override {
    return std::make_unique<CleanMessage>();
  }
};

void set_up_log() {
  auto log = spdlog::stderr_color_mt("elsie");
  auto pattern = std::make_unique<spdlog::pattern_formatter>();
  pattern->add_flag<CleanMessage>('*').set_pattern("elsie: %^%l%$: %*");
  log->set_formatter(std::move(pattern));
  spdlog::set_default_logger(log);
  const char* level = std::getenv("ELSIE_LOG");
  spdlog::set_level(level ? spdlog::level::from_str(level) : spdlog::level::warn);
}

/// Runs the job; every error becomes a message and an exit code.
int finish(const Job& job) {
  try {
    return job();
  } catch (const build::BuildError& error) {  // the compiler's own words, perhaps in colours
    std::cerr << error.message() << '\n';
    return error.exit_code();
  } catch (const base::Error& error) {
    err() << error.message() << '\n';
    return error.exit_code();
  } catch (...) {
    err() << "elsie: " << base::what_was_thrown() << '\n';
    return kOtherFailure;
  }
}

/// A result that did not reach its reader is not a success.
int with_output_written(int exit_code) {
  out().flush();
  if (out()) {
    return exit_code;
  }
  err() << "elsie: standard output could not be written to its end\n";
  return exit_code == kSuccess || exit_code == kGoalMissed ? int{kOtherFailure} : exit_code;
}

/// True if the words ask for a run, and not for help about it.
bool is_run(int argc, char** argv) {
  const auto asks_for_help = [](std::string_view word) { return word == "--help" || word == "-h"; };
  return argc > 1 && std::string_view(argv[1]) == "run" &&
         std::none_of(argv + 2, argv + argc, asks_for_help);
}

/// Parses the command line and does the chosen work. Returns the exit code.
int work(int argc, char** argv) {
  CLI::App program("Elsie: behaviour-based mobile robot control", "elsie");
  program.set_version_flag("--version", "elsie " ELSIE_VERSION);
  program.require_subcommand(1);
  program.footer(kProgramExamples);
  program.failure_message(usage_message);
  Job job;
  add_run_command(program, job);
  try {
    if (!is_run(argc, argv)) {
      command_module().add_commands(program, job);
    }
    check_words(program, argc, argv);
    program.parse(argc, argv);
  } catch (const base::Error& error) {
    err() << error.message() << '\n';
    return error.exit_code();
  } catch (const CLI::ParseError& error) {
    return with_output_written(program.exit(error, out(), err()) == 0 ? kSuccess : kBadInput);
  }
  return with_output_written(finish(job));
}

/// The whole program.
[[noreturn]] void perform(int argc, char** argv) {
  fix_arithmetic(argv);
  // A file that grows beyond its limit is an error of writing, as on a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  set_up_log();
  // Camera pictures are small: where Mesa draws them in software, handing them to threads costs
  // more than it gains. Set here: no other code runs yet that could read the environment.
  setenv("LP_NUM_THREADS", "0", 0);
  for (const auto& [command, work] : {std::pair(kWorkerCommand, &CommandModule::work),
                                      std::pair(kTemplateCommand, &CommandModule::stand_by)}) {
    if (argc == 2 && std::string_view(argv[1]) == command) {
      process::end_with(finish([work = work] {
        (command_module().*work)();
        return int{kOtherFailure};  // it has not ended the process
      }));
    }
  }
  keep_output(argc, argv);
  process::report_crashes(kPluginFailed);
  end_at_once_when_interrupted();
  constexpr int kWordsToLoad = 5;
  const auto longest_s = argc == kWordsToLoad && std::string_view(argv[1]) == kLoadCommand
                             ? parse_number(argv[4])
                             : std::nullopt;
  const int exit_code = longest_s ? finish([&] { return load_alone(argv[2], argv[3], *longest_s); })
                                  : work(argc, argv);
  // It does not return, so functions that plugins have registered for the end of the process do not
  // run. But their output is written.
  std::cout.flush();
  std::fflush(nullptr);
  process::end_with(exit_code);
}

}  // namespace

}  // namespace elsie::program

// An exception here ends the program with a report of a crash.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) { elsie::program::perform(argc, argv); }
