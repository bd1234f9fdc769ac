// The reader of those who made the format, as viewers use it.
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace elsie::test {

/// What official_reader/read.mjs finds in a file: by its indexes, or from its beginning as far as
/// it goes. Its packages are installed from the npm registry into the build folder the first time.
/// Throws std::runtime_error with a sentence when node or the registry are not there.
nlohmann::json read_officially(const std::filesystem::path& file, const std::string& mode);

}  // namespace elsie::test
