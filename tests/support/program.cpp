#include "program.h"

#include <cstdlib>
#include <fstream>

#include <sys/wait.h>

#include "places.h"

namespace fs = std::filesystem;

namespace elsie::test {
namespace {

std::string read_file(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

Workplace::Workplace() {
  for (const char* data :
       {"experiments", "worlds", "robots", "fuzzy_models", "training_sets", "examples"}) {
    fs::create_directory_symlink(source_path(data), folder_ / data);
  }
}

ProgramRun Workplace::sh(const std::string& command) const {
  write(".command", command + '\n');
  const std::string bin = build_path("bin");
  const std::string line = "cd '" + folder_.path().string() + "' && PATH='" + bin +
                           "':\"$PATH\" sh -e .command >.out 2>.err </dev/null";
  const int status = std::system(line.c_str());
  ProgramRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = read(".out");
  run.err = read(".err");
  return run;
}

void Workplace::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder_ / name, std::ios::binary) << text;
}

std::string Workplace::read(const std::string& name) const { return read_file(folder_ / name); }

}  // namespace elsie::test
