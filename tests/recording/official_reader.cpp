#include "official_reader.h"

#include <stdexcept>

#include "npm_packages.h"
#include "program.h"

namespace elsie::test {

nlohmann::json read_officially(const std::filesystem::path& file, const std::string& mode) {
  const Workplace here;
  const auto packages = npm_packages("recording/official_reader", {"read.mjs"});
  const ProgramRun run = here.sh("node '" + (packages / "read.mjs").string() + "' " + mode + " '" +
                                 file.string() + "'");
  if (run.out.empty()) {
    throw std::runtime_error("the official MCAP reader failed: " + run.err);
  }
  return nlohmann::json::parse(run.out);
}

}  // namespace elsie::test
