#include "places.h"

// The only source of the tests with absolute paths: the compiler's cache serves all others to every
// checkout.
namespace elsie::test {

std::string source_path(const std::string& file) {
  return file.empty() ? ELSIE_SOURCE_DIR : ELSIE_SOURCE_DIR "/" + file;
}

std::string build_path(const std::string& file) { return ELSIE_BINARY_DIR "/" + file; }

std::string plugin_directory() { return ELSIE_PLUGIN_DIR; }

}  // namespace elsie::test
