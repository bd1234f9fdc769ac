// Packages from the npm registry: the official readers and clients of other makers' formats.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace elsie::test {

/// The folder in the build where the packages of a folder of the tests are
/// ("recording/official_reader"), with its scripts. They are installed the first time, and when its
/// lock file has changed. Throws std::runtime_error with a sentence when node or the registry are
/// not there.
std::filesystem::path npm_packages(const std::string& folder,
                                   const std::vector<std::string>& scripts);

}  // namespace elsie::test
