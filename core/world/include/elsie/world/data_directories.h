// Directories of data: worlds, robot templates, experiments, fuzzy models, training sets.
#pragma once

#include <string>
#include <vector>

namespace elsie::world {

/// The environment variable: directories separated by colons; empty ones are ignored.
inline constexpr const char* kDataPathVariable = "ELSIE_DATA_PATH";

/// The directories in the order in which they are searched: those of the environment variable,
/// `../share/elsie` seen from the folder of the running program, `share/elsie` of the installation
/// that libelsie is in. Each stands once; some may not exist. Only this function reads the
/// variable.
std::vector<std::string> default_data_directories();

/// The path of the world or experiment `name`: `name` itself when it exists or is absolute, else
/// the first such file in the data directories, so that "worlds/maze.xml" opens the shipped world
/// from any folder. Throws WorldError with the nearest name when there is none.
std::string find_document(const std::string& name,
                          const std::vector<std::string>& data_directories);

}  // namespace elsie::world
