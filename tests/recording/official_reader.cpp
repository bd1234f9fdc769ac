#include "official_reader.h"

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

/// The folder in the build where the packages are.
fs::path installed() {
  const fs::path from = source_path("tests/recording/official_reader");
  const fs::path to = build_path("tests/recording/official_reader");
  const fs::path done = to / "installed";  // the lock file that was installed from
  const std::string lock = content(from / "package-lock.json");
  fs::create_directories(to);
  for (const char* file : {"package.json", "package-lock.json", ".npmrc", "read.mjs"}) {
    fs::copy_file(from / file, to / file, fs::copy_options::overwrite_existing);
  }
  if (content(done) == lock) {
    return to;
  }
  const Workplace here;
  if (here.sh("command -v node && command -v npm").exit_code != 0) {
    throw std::runtime_error(
        "the official MCAP reader needs node and npm, which are not here; "
        "scripts/install-dependencies installs them");
  }
  const ProgramRun run = here.sh("cd '" + to.string() + "' && npm ci --no-audit --no-fund");
  if (run.exit_code != 0) {
    throw std::runtime_error(
        "the packages of the official MCAP reader could not be installed from the npm registry; "
        "without a network this test cannot pass. npm says:\n" +
        run.err);
  }
  std::ofstream(done, std::ios::binary) << lock;
  return to;
}

}  // namespace

nlohmann::json read_officially(const fs::path& file, const std::string& mode) {
  const Workplace here;
  const ProgramRun run = here.sh("node '" + (installed() / "read.mjs").string() + "' " + mode +
                                 " '" + file.string() + "'");
  if (run.out.empty()) {
    throw std::runtime_error("the official MCAP reader failed: " + run.err);
  }
  return nlohmann::json::parse(run.out);
}

}  // namespace elsie::test
