#include "npm_packages.h"

#include <fstream>
#include <stdexcept>

#include "places.h"
#include "program.h"

namespace fs = std::filesystem;

namespace elsie::test {
namespace {

std::string content(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

fs::path npm_packages(const std::string& folder, const std::vector<std::string>& scripts) {
  const fs::path from = source_path("tests/" + folder);
  const fs::path to = build_path("tests/" + folder);
  const fs::path done = to / "installed";  // the lock file that was installed from
  const std::string lock = content(from / "package-lock.json");
  fs::create_directories(to);
  std::vector<std::string> files{"package.json", "package-lock.json", ".npmrc"};
  files.insert(files.end(), scripts.begin(), scripts.end());
  for (const std::string& file : files) {
    fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
  }
  if (content(done) == lock) {
    return to;
  }
  const Workplace here;
  if (here.sh("command -v node && command -v npm").exit_code != 0) {
    throw std::runtime_error("the packages of tests/" + folder +
                             " need node and npm, which are not here; "
                             "scripts/install-dependencies installs them");
  }
  const ProgramRun run = here.sh("cd '" + to.string() + "' && npm ci --no-audit --no-fund");
  if (run.exit_code != 0) {
    throw std::runtime_error("the packages of tests/" + folder +
                             " could not be installed from the npm registry; "
                             "without a network this test cannot pass. npm says:\n" +
                             run.err);
  }
  std::ofstream(done, std::ios::binary) << lock;
  return to;
}

}  // namespace elsie::test
