// The paths of the source tree and the build, for tests.
#pragma once

#include <string>

namespace elsie::test {

/// The path of a file in the source tree; "" is the tree itself.
std::string source_path(const std::string& file);

/// The path of a file in the build folder, for files of a test.
std::string build_path(const std::string& file);

/// The folder of the shipped plugins' libraries.
std::string plugin_directory();

}  // namespace elsie::test
