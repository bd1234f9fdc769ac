// elsie python: a Python whose runs of the module `elsie` have the same bits as those of this
// program.
//
// The program has the C library's mathematics on one path (arithmetic.h), which a process must ask
// for before it begins. Programs that it starts inherit that.
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "elsie/plugin/own_library.h"

#include "command.h"
#include "streams.h"

namespace elsie::program {

namespace {

namespace fs = std::filesystem;

/// The folder of the package `elsie`, seen from libelsie: in a build or an installation, or in a
/// wheel, where the libraries are in the package.
fs::path folder_of_package() {
  const fs::path libraries = fs::weakly_canonical(plugin::file_of_this_library()).parent_path();
  for (const fs::path& folder : {libraries / "python3" / "dist-packages",
                                 libraries.parent_path().parent_path().parent_path()}) {
    std::error_code error;
    if (fs::exists(folder / "elsie" / "__init__.py", error)) return folder;
  }
  throw BadInput("this Elsie has no module for Python beside " + libraries.string() +
                 "; build it with `make python`, or install the package python3-elsie");
}

int become_python(const std::vector<std::string>& words) {
  const char* const path = std::getenv("PYTHONPATH");
  const std::string folder = folder_of_package().string();
  setenv("PYTHONPATH", (path && *path ? folder + ":" + path : folder).c_str(), 1);
  setenv("PYTHONHASHSEED", "0", 0);  // sets of texts have one order; the user's own choice stays
  const char* const chosen = std::getenv("ELSIE_PYTHON");
  const std::string python = chosen && *chosen ? chosen : "python3";
  std::vector<char*> arguments{const_cast<char*>(python.c_str())};
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  give_output_back();
  execvp(python.c_str(), arguments.data());
  throw BadInput("'" + python + "' cannot be started: " + std::generic_category().message(errno) +
                 "; install python3, or name an interpreter in ELSIE_PYTHON");
}

}  // namespace

void add_python_command(CLI::App& program, Job& job) {
  CLI::App* command = program.add_subcommand(
      "python", "Start Python with the module elsie, whose runs then have the bits of `elsie run`");
  command->prefix_command();
  command->footer(R"(
All words go to the interpreter: python3, or what the variable ELSIE_PYTHON names.

Examples:
  elsie python learn.py --seed 7
  elsie python -m pytest
  elsie python -c 'import elsie; print(elsie.same_bits())')");
  command->callback(
      [command, &job] { job = [words = command->remaining()] { return become_python(words); }; });
}

}  // namespace elsie::program
