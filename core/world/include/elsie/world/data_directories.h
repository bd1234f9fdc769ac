// Directories of data: worlds, robot templates, experiments, fuzzy models, training sets.
#pragma once

#include <string>
#include <vector>

namespace elsie::world {

/// An environment variable with directories, separated by colons. Empty entries are ignored.
inline constexpr const char* kDataPathVariable = "ELSIE_DATA_PATH";

/// The directories in the order in which they are searched: those of the environment variable,
/// `../share/elsie` relative to the folder of the running program, and `share/elsie` of the
/// installation that contains libelsie. Each appears once; some may not exist. Only this function
/// reads the variable.
std::vector<std::string> default_data_directories();

/// The path of the world or experiment `name`: `name` itself if it exists or is absolute, else the
/// first such file in the data directories, so that "worlds/maze.xml" opens the shipped world from
/// any folder. Throws WorldError with the nearest existing name if there is no such file.
std::string find_document(const std::string& name,
                          const std::vector<std::string>& data_directories);

}  // namespace elsie::world
