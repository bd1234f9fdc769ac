// elsie build: compiles a plugin of one source file.
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "elsie/base/read_whole.h"
#include "elsie/build/source_build.h"
#include "elsie/files/outputs.h"
#include "elsie/files/write_whole.h"
#include "elsie/plugin/host.h"
#include "elsie/plugin/kind_name.h"

#include "command.h"
#include "environment.h"
#include "output_files.h"
#include "streams.h"

namespace elsie::program {

namespace {

namespace fs = std::filesystem;

struct BuildOptions {
  std::string source;
  std::string output;
};

int build(const BuildOptions& options) {
  const fs::path output =
      options.output.empty() ? fs::path(options.source).stem().string() + ".so" : options.output;
  if (output.extension() != ".so") {
    throw BadInput("--output: a plugin library's name must end in .so, but '" + output.string() +
                   "' does not");
  }
  require_writable(output, "--output");
  files::require_apart({{"--output", output}}, {options.source});
  const auto built = compiled(options.source);
  // A library that cannot be loaded is not copied to the output.
  const LoadingLimit limit;
  const plugin::Host host({{built.library, "built", options.source}});
  const auto& file = host.report().directories.front().files.front();
  if (file.status != plugin::FileStatus::loaded) {
    throw BadInput("'" + options.source + "' was compiled, but its library " + file.sentence);
  }
  files::write_whole_or_throw(output, base::read_whole(built.library, base::kAnySize));
  for (const auto& plugin : file.plugins) {
    out() << output.string() << ": " << plugin::kind_name(plugin.kind) << " '" << plugin.name << "'"
          << (built.from_cache ? ", compiled before" : "") << '\n';
  }
  return kSuccess;
}

}  // namespace

void add_build_command(CLI::App& program, Job& job) {
  CLI::App* command =
      program.add_subcommand("build", "Compile a plugin of one source file to a library");
  command->footer(
      "\nExamples:\n  elsie build my_behavior.cpp\n"
      "  elsie build my_behavior.cpp --output plugins/my_behavior.so\n\n"
      "The compiler is $CXX, else c++; $CXXFLAGS are added to its flags. `elsie run WORLD "
      "--plugin\n"
      "my_behavior.cpp` compiles and runs in one go.\n");
  auto options = std::make_shared<BuildOptions>();
  command->add_option("SOURCE", options->source, "C++ source file")->required();
  command
      ->add_option("-o,--output", options->output,
                   "Library to write; default: the source's name with .so, here")
      ->type_name("FILE.so");
  command->callback([&job, options] { job = [options] { return build(*options); }; });
}

}  // namespace elsie::program
