// elsie page: writes a recorded run as one HTML file that plays it.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "elsie/base/number_text.h"
#include "elsie/base/read_whole.h"
#include "elsie/files/outputs.h"
#include "elsie/files/write_whole.h"
#include "elsie/mcap/reader.h"
#include "elsie/page/run_page.h"

#include "arguments.h"
#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace {

struct PageCommandOptions {
  PluginOptions plugins;
  std::string recording;
  std::optional<std::string> output;
  double megabytes = 3.0;
};

constexpr const char* kPageExamples = R"(
Examples:
  elsie run worlds/clutter.xml --record clutter.mcap
  elsie page clutter.mcap
  elsie page clutter.mcap --output clutter.html
)";

int page(const PageCommandOptions& options) {
  const std::filesystem::path file =
      options.output.value_or(std::filesystem::path(options.recording).stem().string() + ".html");
  if (file.extension() != ".html") {
    throw BadInput("--output: a page's name must end in .html, but '" + file.string() +
                   "' does not");
  }
  files::require_apart({{"--output", file}}, {options.recording});
  require_replaceable(file, "--output", "page");
  if (base::why_unreadable(options.recording).empty() && !mcap::may_be_mcap(options.recording)) {
    throw BadInput("'" + options.recording +
                   "' is not a recording; expected a file that `elsie run WORLD --record "
                   "FILE.mcap` or `elsie replay DATABASE RUN --record FILE.mcap` has written");
  }
  const plugin::Host host = load_plugins(options.plugins);
  constexpr double kMegabyte = 1e6;
  page::RunPage made;
  try {
    made = page::run_page(options.recording, host,
                          {static_cast<std::size_t>(options.megabytes * kMegabyte)});
  } catch (const mcap::McapError& error) {
    throw BadInput(error.what());
  }
  files::write_whole_or_throw(file, made.html);
  const double size = static_cast<double>(made.html.size()) / kMegabyte;
  out() << "wrote " << file.string() << ": " << base::fixed_text(size, 2) << " MB, a pose every "
        << base::seconds_text(made.poses_every_s) << '\n';
  if (size > options.megabytes) {
    err() << "elsie: " << file.string() << " has more than the "
          << base::number_text(options.megabytes)
          << " MB of --megabytes, although its run is sampled as coarsely as a page can be; "
             "a recording of fewer robots (`elsie run --record-robots`) or a smaller image of the "
             "floor makes it smaller\n";
  }
  return kSuccess;
}

}  // namespace

void add_page_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "page", "Write a recorded run as one HTML file that plays it in any browser");
  command->footer(kPageExamples);
  auto options = std::make_shared<PageCommandOptions>();
  command
      ->add_option("RECORDING", options->recording,
                   "Recording, written by `elsie run --record FILE.mcap`")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Page to write; default: the recording's name with .html, here")
      ->type_name("FILE.html");
  command
      ->add_option(
          "--megabytes", options->megabytes,
          "A longer run is sampled more coarsely, so that the page is no larger if that is "
          "possible; if not, a sentence says so")
      ->check(number_between(0.2, 100))
      ->capture_default_str();
  options->plugins.add_to(*command);
  command->callback([&job, options] { job = [options] { return page(*options); }; });
}

}  // namespace elsie::program
